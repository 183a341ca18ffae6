#include "sim/recording/npy_array.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

/// A file as NumPy writes it: header padded to 64 bytes in all.
std::string npy(const std::string& dictionary, const std::string& data, int version = 1) {
    std::string header = dictionary;
    const std::size_t before = version == 1 ? 10 : 12;
    while ((before + header.size() + 1) % 64 != 0) header += ' ';
    header += '\n';
    std::string bytes = "\x93NUMPY";
    append_number(bytes, static_cast<std::uint64_t>(version), 2);
    append_number(bytes, header.size(), version == 1 ? 2 : 4);
    return bytes + header + data;
}

std::string dictionary(const std::string& descr, const std::string& shape,
                       const std::string& fortran = "False") {
    return "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
}

std::string npy_refusal(const std::string& bytes) {
    return message_of([&] { return read_npy(bytes_in(bytes)).shape.size(); });
}

TEST_CASE("numbers of every type are read as what they are", "[recording]") {
    using namespace std::string_literals;
    struct Case {
        std::string descr, data;
        double value;
    };
    for (const Case& c :
         {Case{"|i1", "\xfe"s, -2.0}, Case{"|u1", "\xfe"s, 254.0}, Case{"<i2", "\xfe\xff"s, -2.0},
          Case{">i2", "\xff\xfe"s, -2.0}, Case{"<u2", "\xfe\xff"s, 65534.0},
          Case{"<i4", "\x00\x00\x01\x00"s, 65536.0}, Case{">u4", "\x80\x00\x00\x00"s, 2147483648.0},
          Case{"<i8", "\xff\xff\xff\xff\xff\xff\xff\xff"s, -1.0},
          Case{"<f4", "\x00\x00\xc0\x3f"s, 1.5}, Case{">f8", "\x3f\xf8\0\0\0\0\0\0"s, 1.5},
          Case{"|b1", "\x01"s, 1.0}}) {
        INFO(c.descr);
        const std::string bytes = npy(dictionary(c.descr, "(1,)"), c.data);
        CHECK(read_npy(bytes_in(bytes)).real(0) == c.value);
    }
    const std::string pair = npy(dictionary("<c8", "(1,)"), "\x00\x00\xc0\x3f\x00\x00\x80\xbf"s);
    CHECK(read_npy(bytes_in(pair)).real(0) == 1.5);
    CHECK(read_npy(bytes_in(pair)).imaginary(0) == -1.0);
    const std::string text =
        npy(dictionary("<U3", "(2,)"), "a\0\0\0b\0\0\0\0\0\0\0c\0\0\0\0\0\0\0\0\0\0\0"s);
    CHECK(read_npy(bytes_in(text)).text(0) == "ab");
    CHECK(read_npy(bytes_in(text)).text(1) == "c");
}

TEST_CASE("shapes and orders of all versions of the format are read", "[recording]") {
    for (const int version : {1, 2, 3}) {
        const std::string bytes =
            npy(dictionary("<i2", "(3, 2)", "True"), std::string(12, '\0'), version);
        const NpyArray array = read_npy(bytes_in(bytes));
        CHECK(array.shape == std::vector<std::size_t>{3, 2});
        CHECK(array.fortran_order);
        CHECK(array.data_offset % 64 == 0);
        CHECK(array.data.size() == 12);
    }
    const std::string scalar = npy(dictionary("<i2", "()"), std::string(2, '\0'));
    CHECK(read_npy(bytes_in(scalar)).size() == 1);
    const std::string none = npy(dictionary("<i2", "(0, 7)"), "");
    CHECK(read_npy(bytes_in(none)).size() == 0);
}

TEST_CASE("what is written is NumPy's format and comes back", "[recording]") {
    const std::string data = "abcdefghijkl";
    const std::string bytes = write_npy("<i2", {3, 2}, data);
    CHECK(bytes == npy("{'descr': '<i2', 'fortran_order': False, 'shape': (3, 2), }", data));
    CHECK(write_npy("<f8", {1}, "12345678") ==
          npy("{'descr': '<f8', 'fortran_order': False, 'shape': (1, ), }", "12345678"));
    const NpyArray array = read_npy(bytes_in(bytes));
    CHECK(std::string(array.data.begin(), array.data.end()) == data);
}

TEST_CASE("pickled objects are refused, not run", "[recording]") {
    CHECK(npy_refusal(npy(dictionary("|O", "(1,)"), "\x80\x04.")) ==
          "byte 6: elements of type \"|O\": are pickled Python objects, and those are programs; "
          "save plain numbers; this is never run");
    const std::string records =
        "{'descr': [('a', '<i2')], 'fortran_order': False, 'shape': (1,), }";
    CHECK(npy_refusal(npy(records, "ab")).rfind("byte 20: records of several fields", 0) == 0);
}

TEST_CASE("files that are not what they say are refused with the byte", "[recording]") {
    const std::string whole = npy(dictionary("<i2", "(3, 2)"), std::string(12, 'x'));
    CHECK(npy_refusal("PK") == "byte 0: is not NumPy's array format; name an .npy file");
    CHECK(npy_refusal(whole.substr(0, 6)).rfind("byte 6: the data end inside the version", 0) == 0);
    CHECK(npy_refusal(whole.substr(0, 9)).rfind("byte 9: the data end inside the header", 0) == 0);
    CHECK(npy_refusal(whole.substr(0, 40)).rfind("byte 40: the data end inside the header", 0) ==
          0);
    CHECK(
        npy_refusal(whole.substr(0, whole.size() - 1)).rfind("byte 128: 11 bytes of elements", 0) ==
        0);
    CHECK(npy_refusal(whole + "y").rfind("byte 128: 13 bytes of elements", 0) == 0);
    for (const std::string shape :
         {"(4294967296, 4294967296, 4294967296)", "(18446744073709551615, 2)", "(9, 9)"})
        CHECK(npy_refusal(npy(dictionary("<i2", shape), "ab")).find("2 bytes of elements") !=
              std::string::npos);
    for (const auto& [broken, problem] : std::vector<std::pair<std::string, std::string>>{
             {"{'descr': '<i2'}", "descr, fortran_order or shape is missing"},
             {"{'descr': '<i2', 'shape': (1,), 'shape': (1,), }", "a key twice"},
             {"{'descr': '<i2', 'fortran_order': Maybe, }", "True or False is missing"},
             {"{'descr': '<i2', 'size': 3, }", "an unknown key"},
             {"{'shape': (99999999999999999999,), }", "a length is missing or too large"},
             {"{'shape': (-1,), }", "a length is missing or too large"},
             {"[]", "'{' is missing"}}) {
        INFO(broken);
        const std::string message = npy_refusal(npy(broken, ""));
        CHECK(message.rfind("byte ", 0) == 0);
        CHECK(message.find("in the header: " + problem) != std::string::npos);
    }
    CHECK(npy_refusal(npy(dictionary("<i3", "(1,)"), "abc")).find("are not known here") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
