#include "sim/dataset/hdf5_table.hpp"

#include <functional>
#include <numeric>
#include <type_traits>

#include "sim/core/expect.hpp"
#include "sim/dataset/chunk_packer.hpp"
#include "sim/dataset/hdf5_number.hpp"

namespace specula {

namespace {

/// gzip makes nothing smaller than a 1032nd; a table that claims more was not written in full.
constexpr double best_compression = 1100.0;

/// The file's rows [first, first + n) as HDF5 selects them.
struct RowSelection {
    Hdf5Handle in_file;
    Hdf5Handle in_memory;

    RowSelection(hid_t table, const std::vector<std::size_t>& size, std::size_t first,
                 std::size_t n)
        : in_file(H5Dget_space(table), H5Sclose), in_memory(memory_space(size, n), H5Sclose) {
        std::vector<hsize_t> start(size.size(), 0), count(size.begin(), size.end());
        start[0] = first;
        count[0] = n;
        H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    }

  private:
    static hid_t memory_space(const std::vector<std::size_t>& size, std::size_t n) {
        std::vector<hsize_t> count(size.begin(), size.end());
        count[0] = n;
        return H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr);
    }
};

/// What the files hold that a virtual table shows: at least the table's own bytes.
double bytes_behind(const Hdf5Handle& creation, const std::filesystem::path& index,
                    const std::string& name) {
    std::size_t n = 0;
    H5Pget_virtual_count(creation, &n);
    double bytes = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        char shown[1024] = {};
        H5Pget_virtual_filename(creation, i, shown, sizeof shown - 1);
        const std::string beside = shown;
        if (beside.find('/') != std::string::npos)
            hdf5_read_failed(index, name, "shows a file of another folder");
        std::error_code missing;
        const auto size = std::filesystem::file_size(index.parent_path() / beside, missing);
        if (missing) hdf5_read_failed(index, name, "shows " + beside + ", which is not there");
        bytes += static_cast<double>(size);
    }
    return bytes;
}

std::vector<hsize_t> chunk_offset(const std::vector<std::size_t>& size, std::size_t row) {
    std::vector<hsize_t> offset(size.size(), 0);
    offset[0] = row;
    return offset;
}

}  // namespace

std::size_t TableShape::values_per_row() const {
    return std::accumulate(size.begin() + 1, size.end(), std::size_t{1}, std::multiplies<>());
}

Hdf5Table::Hdf5Table(Hdf5Table&& other) noexcept
    : file_(std::move(other.file_)),
      name_(std::move(other.name_)),
      handle_(other.handle_),
      shape_(std::move(other.shape_)) {
    other.handle_ = -1;
}

Hdf5Table::~Hdf5Table() {
    if (handle_ >= 0) H5Dclose(handle_);
}

template <typename T>
void Hdf5Table::write_rows(std::size_t first, std::span<const T> values) {
    const T* type_of = nullptr;
    const std::size_t n = values.size() / shape_.values_per_row();
    SPECULA_EXPECT(n * shape_.values_per_row() == values.size() && first + n <= shape_.size[0]);
    if (n == 0) return;
    const RowSelection rows(handle_, shape_.size, first, n);
    if (H5Dwrite(handle_, memory_type(type_of), rows.in_memory, rows.in_file, H5P_DEFAULT,
                 values.data()) < 0)
        hdf5_write_failed(file_, name_);
}

void Hdf5Table::write_chunk(std::size_t row, std::span<const std::uint8_t> chunk) {
    SPECULA_EXPECT(shape_.rows_per_chunk == 1 && row < shape_.size[0]);
    if (H5Dwrite_chunk(handle_, H5P_DEFAULT, 0, chunk_offset(shape_.size, row).data(), chunk.size(),
                       chunk.data()) < 0)
        hdf5_write_failed(file_, name_);
}

void Hdf5Table::check_claim(double bytes_per_value) const {
    double bytes = bytes_per_value;
    for (const std::size_t n : shape_.size) bytes *= static_cast<double>(n);
    const Hdf5Handle creation(H5Dget_create_plist(handle_), H5Pclose);
    const double stored = H5Pget_layout(creation) == H5D_VIRTUAL
                              ? bytes_behind(creation, file_, name_)
                              : static_cast<double>(H5Dget_storage_size(handle_));
    if (bytes > best_compression * stored)
        hdf5_read_failed(file_, name_, "is larger than what the file holds of it");
}

template <typename T>
std::vector<T> Hdf5Table::read_rows(std::size_t first, std::size_t n_rows) const {
    const T* type_of = nullptr;
    const Hdf5Handle type(H5Dget_type(handle_), H5Tclose);
    if (H5Tequal(type, file_type(type_of)) <= 0)
        hdf5_read_failed(file_, name_, "holds another type of number");
    check_claim(sizeof(T));
    if (first + n_rows > shape_.size[0]) hdf5_read_failed(file_, name_, "has too few rows");
    std::vector<T> values(n_rows * shape_.values_per_row());
    if (values.empty()) return values;
    if constexpr (std::is_same_v<T, std::int16_t>)
        if (unpack_rows(first, values)) return values;
    const RowSelection rows(handle_, shape_.size, first, n_rows);
    if (H5Dread(handle_, memory_type(type_of), rows.in_memory, rows.in_file, H5P_DEFAULT,
                values.data()) < 0)
        hdf5_read_failed(file_, name_, "cannot be read: " + last_hdf5_reason());
    return values;
}

bool Hdf5Table::is_packed_by_row() const {
    constexpr H5Z_filter_t filters[] = {H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE,
                                        H5Z_FILTER_FLETCHER32};
    const Hdf5Handle creation(H5Dget_create_plist(handle_), H5Pclose);
    if (H5Pget_layout(creation) != H5D_CHUNKED) return false;
    std::vector<hsize_t> chunk(shape_.size.begin(), shape_.size.end()), found(chunk.size());
    chunk[0] = 1;
    H5Pget_chunk(creation, static_cast<int>(found.size()), found.data());
    if (found != chunk || H5Pget_nfilters(creation) != std::ssize(filters)) return false;
    for (unsigned i = 0; i < std::size(filters); ++i) {
        unsigned flags = 0;
        std::size_t n_values = 0;
        if (H5Pget_filter2(creation, i, &flags, &n_values, nullptr, 0, nullptr, nullptr) !=
            filters[i])
            return false;
    }
    return true;
}

bool Hdf5Table::unpack_rows(std::size_t first, std::span<std::int16_t> values) const {
    if (!is_packed_by_row()) return false;
    const std::size_t per_row = shape_.values_per_row();
    ChunkUnpacker unpacker;
    std::vector<std::uint8_t> chunk;
    for (std::size_t row = 0; row * per_row < values.size(); ++row) {
        chunk.clear();
        if (!append_chunk(first + row, chunk) ||
            !unpacker.unpack(chunk, values.subspan(row * per_row, per_row)))
            return false;
    }
    return true;
}

bool Hdf5Table::append_chunk(std::size_t row, std::vector<std::uint8_t>& bytes) const {
    const auto offset = chunk_offset(shape_.size, row);
    hsize_t n = 0;
    std::uint32_t skipped_filters = 0;
    const std::size_t begin = bytes.size();
    if (H5Dget_chunk_storage_size(handle_, offset.data(), &n) < 0 || n == 0) return false;
    bytes.resize(begin + n);
    return H5Dread_chunk(handle_, H5P_DEFAULT, offset.data(), &skipped_filters,
                         bytes.data() + begin) >= 0 &&
           skipped_filters == 0;
}

void Hdf5Table::read_chunk(std::size_t row, std::vector<std::uint8_t>& bytes) const {
    if (!append_chunk(row, bytes))
        hdf5_read_failed(file_, name_, "has a chunk that cannot be read");
}

#define SPECULA_TABLE_TYPE(T)                                                \
    template void Hdf5Table::write_rows<T>(std::size_t, std::span<const T>); \
    template std::vector<T> Hdf5Table::read_rows<T>(std::size_t, std::size_t) const;
SPECULA_TABLE_TYPE(std::int16_t)
SPECULA_TABLE_TYPE(std::int32_t)
SPECULA_TABLE_TYPE(std::uint64_t)
SPECULA_TABLE_TYPE(std::uint8_t)
SPECULA_TABLE_TYPE(float)
SPECULA_TABLE_TYPE(double)
#undef SPECULA_TABLE_TYPE

}  // namespace specula
