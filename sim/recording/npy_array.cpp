#include "sim/recording/npy_array.hpp"

#include <algorithm>
#include <charconv>

#include "sim/core/expect.hpp"
#include "sim/recording/npy_header.hpp"

namespace specula {

namespace {

constexpr char magic[] = "\x93NUMPY";
constexpr std::size_t magic_bytes = 6;
constexpr std::size_t longest_header = 1 << 16;

struct KindSizes {
    char kind;
    std::vector<std::size_t> sizes;
};

bool is_possible(char kind, std::size_t item_bytes) {
    static const std::vector<KindSizes> known{
        {'i', {1, 2, 4, 8}}, {'u', {1, 2, 4, 8}}, {'f', {4, 8}}, {'c', {8, 16}}, {'b', {1}}};
    if (kind == 'S') return item_bytes >= 1 && item_bytes <= 4096;
    if (kind == 'U') return item_bytes >= 4 && item_bytes <= 4 * 4096;
    for (const KindSizes& each : known)
        if (each.kind == kind) return std::ranges::count(each.sizes, item_bytes) == 1;
    return false;
}

void read_descr(const std::string& descr, NpyArray& array) {
    const auto fail = [&](const std::string& problem, const std::string& remedy) {
        fail_at(magic_bytes, format("elements of type \"{}\": {}", descr, problem), remedy);
    };
    if (descr.find('O') != std::string::npos)
        fail("are pickled Python objects, and those are programs",
             "save plain numbers; this is never run");
    if (descr.size() < 3 || std::string("<>|=").find(descr[0]) == std::string::npos)
        fail("are not known here", "save integers, floats or complex numbers");
    array.big_endian = descr[0] == '>';
    array.kind = descr[1];
    std::size_t n = 0;
    const char* end = descr.data() + descr.size();
    const auto result = std::from_chars(descr.data() + 2, end, n);
    if (result.ec != std::errc{} || result.ptr != end || n > longest_header) n = 0;
    array.item_bytes = array.kind == 'U' ? 4 * n : n;
    if (!is_possible(array.kind, array.item_bytes))
        fail("are not known here", "save integers, floats or complex numbers");
}

std::uint64_t bits_at(const NpyArray& array, std::size_t offset, std::size_t size) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < size; ++k) {
        const std::size_t from = array.big_endian ? size - 1 - k : k;
        bits |= static_cast<std::uint64_t>(array.data[offset + from]) << (8 * k);
    }
    return bits;
}

double float_at(const NpyArray& array, std::size_t offset, std::size_t size) {
    const std::uint64_t bits = bits_at(array, offset, size);
    if (size == 8) return std::bit_cast<double>(bits);
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
}

double signed_value(std::uint64_t bits, std::size_t size) {
    const int unused = 64 - 8 * static_cast<int>(size);
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

std::size_t NpyArray::size() const {
    std::size_t n = 1;
    for (const std::size_t length : shape) n *= length;
    return n;
}

double NpyArray::real(std::size_t i) const {
    SPECULA_EXPECT(is_number());
    const std::size_t offset = i * item_bytes;
    if (kind == 'c') return float_at(*this, offset, item_bytes / 2);
    if (kind == 'f') return float_at(*this, offset, item_bytes);
    const std::uint64_t bits = bits_at(*this, offset, item_bytes);
    return kind == 'i' ? signed_value(bits, item_bytes) : static_cast<double>(bits);
}

double NpyArray::imaginary(std::size_t i) const {
    return kind == 'c' ? float_at(*this, i * item_bytes + item_bytes / 2, item_bytes / 2) : 0.0;
}

std::string NpyArray::text(std::size_t i) const {
    const std::size_t width = kind == 'U' ? 4 : 1;
    std::string text;
    for (std::size_t k = 0; k < item_bytes; k += width) {
        const std::uint64_t code = bits_at(*this, i * item_bytes + k, width);
        if (code == 0) break;
        text += code >= ' ' && code < 127 ? static_cast<char>(code) : '?';
    }
    return text;
}

NpyArray read_npy(Bytes bytes) {
    const std::string begins(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                bytes.size(), magic_bytes)));
    if (begins != magic) fail_at(0, "is not NumPy's array format", "name an .npy file");
    const std::uint64_t version = unsigned_at(bytes, magic_bytes, 1, "the version");
    if (version < 1 || version > 3)
        fail_at(magic_bytes, format("version {} of the format", version), "save it again");
    const std::size_t length_bytes = version == 1 ? 2 : 4;
    const std::size_t begin = magic_bytes + 2 + length_bytes;
    const std::size_t length =
        static_cast<std::size_t>(unsigned_at(bytes, magic_bytes + 2, length_bytes, "the header"));
    if (length > longest_header)
        fail_at(magic_bytes + 2, format("a header of {} bytes", length), "is the file whole?");
    if (bytes.size() - begin < length)
        fail_at(bytes.size(), "the data end inside the header", "is the file whole?");
    const NpyHeader header = parse_npy_header(
        std::string(reinterpret_cast<const char*>(bytes.data()) + begin, length), begin);

    NpyArray array;
    read_descr(header.descr, array);
    array.fortran_order = header.fortran_order;
    array.shape = header.shape;
    array.data_offset = begin + length;
    array.data = bytes.subspan(array.data_offset);
    std::size_t claimed = array.item_bytes;
    for (const std::size_t n : array.shape)  // what cannot be there must not wrap around
        claimed = n == 0                            ? 0
                  : claimed > array.data.size() / n ? array.data.size() + 1
                                                    : claimed * n;
    if (claimed != array.data.size())
        fail_at(array.data_offset,
                format("{} bytes of elements follow, which is not what the header says",
                       array.data.size()),
                "is the file whole?");
    return array;
}

std::string write_npy(const std::string& descr, const std::vector<std::size_t>& shape,
                      const std::string& data) {
    std::string axes;
    for (const std::size_t n : shape) axes += format("{}, ", n);
    if (shape.size() > 1) axes.resize(axes.size() - 2);
    std::string header =
        format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", descr, axes);
    const std::size_t unpadded = magic_bytes + 4 + header.size() + 1;
    header += std::string((64 - unpadded % 64) % 64, ' ') + "\n";
    std::string out(magic, magic_bytes);
    append_number(out, 1, 2);  // version 1.0
    append_number(out, header.size(), 2);
    return out + header + data;
}

}  // namespace specula
