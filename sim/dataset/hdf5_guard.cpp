#include "sim/dataset/hdf5_guard.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/hdf5_library.hpp"

namespace specula {

namespace {

/// Whether every step of a path is a hard link: soft and external ones lead elsewhere.
bool is_hard(hid_t file, const std::string& name) {
    for (std::size_t end = 0; end < name.size();) {
        end = std::min(name.find('/', end + 1), name.size());
        H5L_info_t info;
        if (H5Lget_info(file, name.substr(0, end).c_str(), &info, H5P_DEFAULT) < 0 ||
            info.type != H5L_TYPE_HARD)
            return false;
    }
    return true;
}

bool has_house_layout(hid_t table) {
    const Hdf5Handle creation(H5Dget_create_plist(table), H5Pclose);
    if (!creation.valid()) return false;
    if (H5Pget_layout(creation) == H5D_VIRTUAL) return true;  // Hdf5Table looks at its sources
    if (H5Pget_layout(creation) != H5D_CHUNKED || H5Pget_external_count(creation) != 0)
        return false;
    const int n_filters = H5Pget_nfilters(creation);
    for (int i = 0; i < n_filters; ++i) {
        unsigned flags = 0;
        std::size_t n_values = 0;
        const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags,
                                                   &n_values, nullptr, 0, nullptr, nullptr);
        if (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_DEFLATE &&
            filter != H5Z_FILTER_FLETCHER32)
            return false;
    }
    return n_filters >= 0;
}

/// What somebody appended is no part of HDF5's file, so that no checksum covers it. A superblock of
/// version 2 or 3 tells the end: after signature, four bytes, and two addresses of eight.
void check_hdf5_end(const std::filesystem::path& file) {
    constexpr std::streamoff place = 28;
    constexpr int bits_of_byte = 8;
    std::array<unsigned char, sizeof(std::uint64_t)> bytes{};
    std::ifstream in(file, std::ios::binary);
    in.seekg(place).read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    if (!in) return;  // cut short: HDF5 says so
    std::uint64_t end = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) end = end << bits_of_byte | bytes[i];
    const std::uint64_t size = std::filesystem::file_size(file);
    if (size > end)
        hdf5_read_failed(file, "file",
                         format("goes on for {} bytes after the end that it tells", size - end));
}

}  // namespace

void check_hdf5_superblock(const std::filesystem::path& file) {
    constexpr std::array<char, 8> signature{'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
    constexpr char oldest_with_checksum = 2, newest_version = 3;  // of the superblock
    std::array<char, 9> head{};
    std::ifstream(file, std::ios::binary).read(head.data(), head.size());
    if (!std::equal(signature.begin(), signature.end(), head.begin()))
        hdf5_read_failed(file, "file", "cannot be opened as HDF5: file signature not found");
    if (head.back() < oldest_with_checksum)
        throw InputError(format(
            "{}: file: is HDF5 of an old form without checksums, which this program never writes; "
            "if you trust it, h5repack --latest FILE NEW brings it into the new form",
            file.string()));
    if (head.back() <= newest_version) check_hdf5_end(file);
}

bool is_house_hdf5_table(hid_t file, const std::string& name) {
    const Hdf5Handle table(is_hard(file, name) ? H5Dopen2(file, name.c_str(), H5P_DEFAULT) : -1,
                           H5Dclose);
    return table.valid() && has_house_layout(table);
}

hid_t open_hdf5_table(hid_t file, const std::filesystem::path& path, const std::string& name) {
    const hid_t table = is_hard(file, name) ? H5Dopen2(file, name.c_str(), H5P_DEFAULT) : -1;
    if (table < 0) hdf5_read_failed(path, name, "is missing");
    if (has_house_layout(table)) return table;
    H5Dclose(table);
    hdf5_read_failed(path, name, "is stored in a way that this program does not use");
}

}  // namespace specula
