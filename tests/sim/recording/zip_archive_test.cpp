#include "sim/recording/zip_archive.hpp"

#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

/// An archive as Python's zipfile makes it, which numpy.savez uses.
std::string python_archive(const std::string& compression) {
    const TemporaryFolder folder;
    const std::string script =
        "import zipfile\n"
        "z = zipfile.ZipFile('a.npz', 'w', zipfile." +
        compression +
        ")\n"
        "with z.open('first.npy', 'w', force_zip64=True) as f: f.write(b'abc' * 1000)\n"
        "z.writestr('empty.npy', b'')\n"
        "z.writestr('folder/second.npy', bytes(range(256)))\n"
        "z.close()\n";
    if (run_program({.arguments = {"python3", "-c", script}, .folder = folder.path()}).status != 0)
        return "";
    return content_of(folder / "a.npz");
}

/// One stored member "a" of content "xyz", byte by byte.
std::string smallest_archive() {
    std::string bytes;
    const auto sizes = [&bytes] {
        append_number(bytes, 0xeb8eba67, 4);  // CRC-32 of "xyz"
        append_number(bytes, 3, 4);
        append_number(bytes, 3, 4);
        append_number(bytes, 1, 2);  // length of the name
        append_number(bytes, 0, 2);
    };
    bytes += "PK\x03\x04";
    append_number(bytes, 20, 2);
    append_number(bytes, 0, 8);  // flags, method, time
    sizes();
    bytes += "axyz";
    const std::size_t directory = bytes.size();
    bytes += "PK\x01\x02";
    append_number(bytes, 20, 2);
    append_number(bytes, 20, 2);
    append_number(bytes, 0, 8);
    sizes();
    append_number(bytes, 0, 8);
    append_number(bytes, 0, 6);  // attributes, offset of the member
    bytes += "a";
    const std::size_t directory_bytes = bytes.size() - directory;
    bytes += "PK\x05\x06";
    append_number(bytes, 0, 4);
    append_number(bytes, 1, 2);
    append_number(bytes, 1, 2);
    append_number(bytes, directory_bytes, 4);
    append_number(bytes, directory, 4);
    append_number(bytes, 0, 2);
    return bytes;
}

std::string zip_refusal(const std::string& bytes) {
    return message_of([&] {
        const ZipArchive archive(bytes_in(bytes));
        return archive.extract("a");
    });
}

TEST_CASE("archives of another implementation are read", "[recording]") {
    for (const std::string compression : {"ZIP_STORED", "ZIP_DEFLATED"}) {
        const std::string bytes = python_archive(compression);
        if (bytes.empty()) {
            WARN("python3 is not installed: archives of zipfile are not tried");
            return;
        }
        const ZipArchive archive(bytes_in(bytes));
        CHECK(archive.names() ==
              std::vector<std::string>{"empty.npy", "first.npy", "folder/second.npy"});
        const auto content = archive.extract("first.npy");
        REQUIRE(content.size() == 3000);
        CHECK(content[2999] == 'c');
        CHECK(archive.extract("empty.npy").empty());
        CHECK(archive.extract("folder/second.npy")[255] == 255);
    }
}

TEST_CASE("the smallest archive is read, comment or not", "[recording]") {
    std::string bytes = smallest_archive();
    CHECK(ZipArchive(bytes_in(bytes)).extract("a") == std::vector<std::uint8_t>{'x', 'y', 'z'});
    bytes[bytes.size() - 2] = 4;
    bytes += "PK\x05!";
    CHECK(ZipArchive(bytes_in(bytes)).has("a"));
    CHECK_FALSE(ZipArchive(bytes_in(bytes)).has("b"));
}

TEST_CASE("every cut through an archive is refused", "[recording]") {
    const std::string whole = smallest_archive();
    for (std::size_t kept = 0; kept < whole.size(); ++kept) {
        INFO(kept);
        CHECK(zip_refusal(whole.substr(0, kept)).rfind("byte ", 0) == 0);
    }
    for (std::size_t gone = 1; gone < whole.size(); ++gone) {
        INFO(gone);
        CHECK(zip_refusal(whole.substr(gone)).rfind("byte ", 0) == 0);
    }
}

TEST_CASE("sizes, methods and checksums that cannot be are refused with the byte", "[recording]") {
    const std::string whole = smallest_archive();
    const std::size_t entry = whole.find("PK\x01\x02");
    const auto changed = [&](std::size_t at, char to) {
        std::string bytes = whole;
        bytes[at] = to;
        return zip_refusal(bytes);
    };
    CHECK(changed(31, '?') ==
          "byte 31: \"a\" has another checksum than it should; "
          "is the archive whole?");
    CHECK(changed(entry + 8, 1).find("a member is encrypted") != std::string::npos);
    CHECK(changed(entry + 10, 12).find("compression method 12") != std::string::npos);
    CHECK(changed(entry + 10, 8).find("compressed data are damaged") != std::string::npos);
    CHECK(changed(entry + 27, 0x7f).find("which no compression reaches") != std::string::npos);
    CHECK(changed(entry + 24, 2).find("a stored member of two sizes") != std::string::npos);
    CHECK(changed(entry + 42, 5).find("no member's header") != std::string::npos);
    CHECK(changed(0, '?').find("byte 0: no member's header") == 0);
    CHECK(zip_refusal("not an archive at all").find("no ZIP directory ends here") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
