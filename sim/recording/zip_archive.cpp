#include "sim/recording/zip_archive.hpp"

#include <zlib.h>

#include <algorithm>

namespace specula {

namespace {

constexpr std::uint32_t local_mark = 0x04034b50, entry_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::size_t local_bytes = 30, entry_bytes = 46, end_bytes = 22;
constexpr std::size_t longest_comment = 65535;
constexpr unsigned stored = 0, deflated = 8;
constexpr std::size_t best_deflation = 1032;  ///< zlib's own bound: nothing packs better
constexpr const char* damaged = "is the archive whole?";

std::size_t end_of_directory(Bytes bytes) {
    const std::size_t last = bytes.size() < end_bytes ? 0 : bytes.size() - end_bytes;
    const std::size_t first = last > longest_comment ? last - longest_comment : 0;
    for (std::size_t at = last + 1; bytes.size() >= end_bytes && at-- > first;)
        if (u32_at(bytes, at, "the end") == end_mark) return at;
    fail_at(bytes.size(), "no ZIP directory ends here", "name an .npz file, and is it whole?");
}

/// Inflates without header into a buffer of just the size that is due.
std::vector<std::uint8_t> inflated(Bytes packed, std::size_t size, std::size_t offset) {
    std::vector<std::uint8_t> content(size);
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw SystemError("zlib: cannot start");
    stream.next_in = const_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    std::uint8_t nothing = 0;  // an empty vector has no address
    stream.next_out = content.empty() ? &nothing : content.data();
    stream.avail_out = static_cast<uInt>(size);
    const int result = inflate(&stream, Z_FINISH);
    const std::size_t read = packed.size() - stream.avail_in;
    inflateEnd(&stream);
    if (result != Z_STREAM_END || stream.avail_out != 0)
        fail_at(offset + read, "the compressed data are damaged or of another length", damaged);
    return content;
}

}  // namespace

ZipArchive::ZipArchive(Bytes bytes) : bytes_(bytes) {
    const std::size_t end = end_of_directory(bytes);
    const std::size_t n_entries = u16_at(bytes, end + 10, "the directory's end");
    std::size_t at = u32_at(bytes, end + 16, "the directory's end");
    for (std::size_t i = 0; i < n_entries; ++i) at = read_entry(at);
}

std::size_t ZipArchive::read_entry(std::size_t at) {
    constexpr const char* what = "the directory";
    if (u32_at(bytes_, at, what) != entry_mark) fail_at(at, "no entry of the directory", damaged);
    const std::size_t name_bytes = u16_at(bytes_, at + 28, what);
    const std::size_t next = at + entry_bytes + name_bytes + u16_at(bytes_, at + 30, what) +
                             u16_at(bytes_, at + 32, what);
    Member member{.entry = at,
                  .method = u16_at(bytes_, at + 10, what),
                  .checksum = u32_at(bytes_, at + 16, what),
                  .packed_bytes = u32_at(bytes_, at + 20, what),
                  .bytes = u32_at(bytes_, at + 24, what),
                  .offset = u32_at(bytes_, at + 42, what)};
    if (next > bytes_.size()) fail_at(at, "the directory goes beyond the file", damaged);
    if ((u16_at(bytes_, at + 8, what) & 1u) != 0)
        fail_at(at + 8, "a member is encrypted", "save it without a password");
    if (member.method != stored && member.method != deflated)
        fail_at(at + 10, format("compression method {}", member.method),
                "use numpy.savez or savez_compressed");
    if (member.bytes == 0xffffffff || member.packed_bytes == 0xffffffff)
        fail_at(at + 20, "a member of 4 GiB or more", "save it as an .npy file");
    if (member.bytes / best_deflation > member.packed_bytes)
        fail_at(at + 24,
                format("{} bytes out of {}, which no compression reaches", member.bytes,
                       member.packed_bytes),
                damaged);
    const std::string name(reinterpret_cast<const char*>(bytes_.data()) + at + entry_bytes,
                           name_bytes);
    if (!members_.emplace(name, member).second)
        fail_at(at, "a member of a name that another has", damaged);
    return next;
}

std::vector<std::string> ZipArchive::names() const {
    std::vector<std::string> names;
    for (const auto& [name, member] : members_) names.push_back(name);
    return names;
}

Bytes ZipArchive::packed(const Member& member) const {
    constexpr const char* what = "a member's header";
    if (u32_at(bytes_, member.offset, what) != local_mark)
        fail_at(member.offset, "no member's header", damaged);
    const std::size_t begin = member.offset + local_bytes +
                              u16_at(bytes_, member.offset + 26, what) +
                              u16_at(bytes_, member.offset + 28, what);
    if (begin > bytes_.size() || bytes_.size() - begin < member.packed_bytes)
        fail_at(member.offset, "a member goes beyond the file", damaged);
    return bytes_.subspan(begin, member.packed_bytes);
}

std::vector<std::uint8_t> ZipArchive::extract(const std::string& name) const {
    const auto found = members_.find(name);
    if (found == members_.end())
        throw InputError(format("has no member \"{}\"; name one that it has", name));
    const Member& member = found->second;
    const Bytes in = packed(member);
    if (member.method == stored && member.bytes != member.packed_bytes)
        fail_at(member.entry + 24, "a stored member of two sizes", damaged);
    const auto offset = static_cast<std::size_t>(in.data() - bytes_.data());
    std::vector<std::uint8_t> content = member.method == stored
                                            ? std::vector<std::uint8_t>(in.begin(), in.end())
                                            : inflated(in, member.bytes, offset);
    const uLong checksum =
        crc32(crc32(0, nullptr, 0), content.data(), static_cast<uInt>(content.size()));
    if (checksum != member.checksum)
        fail_at(offset, format("\"{}\" has another checksum than it should", name), damaged);
    return content;
}

}  // namespace specula
