#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace specula {

/// What a new table is like; chunks hold `rows_per_chunk` rows and all of the other axes.
struct TableShape {
    std::vector<std::size_t> size;
    std::size_t rows_per_chunk = 1;

    std::size_t values_per_row() const;
};

/// A table of an open Hdf5File, which it must not outlive: written or read some rows at a time, so
/// that its size costs no memory. Made by Hdf5File. Every failure names the file and the table.
class Hdf5Table {
  public:
    Hdf5Table(Hdf5Table&& other) noexcept;
    Hdf5Table& operator=(Hdf5Table&&) = delete;
    ~Hdf5Table();

    const std::vector<std::size_t>& size() const { return shape_.size; }
    std::size_t rows_per_chunk() const { return shape_.rows_per_chunk; }

    /// Whole rows, from row `first` on. Throws SystemError.
    template <typename T>
    void write_rows(std::size_t first, std::span<const T> values);
    /// A chunk of one row that went through the table's filters already. Throws SystemError.
    void write_chunk(std::size_t row, std::span<const std::uint8_t> chunk);

    /// Throws InputError for another type of number, for rows that the file does not hold, and for
    /// damage.
    template <typename T>
    std::vector<T> read_rows(std::size_t first, std::size_t n_rows) const;
    /// Appends the chunk of one row to `bytes` as the file holds it, filters and all. Throws
    /// InputError.
    void read_chunk(std::size_t row, std::vector<std::uint8_t>& bytes) const;

  private:
    friend class Hdf5File;
    Hdf5Table(std::filesystem::path file, std::string name, std::int64_t handle, TableShape shape)
        : file_(std::move(file)),
          name_(std::move(name)),
          handle_(handle),
          shape_(std::move(shape)) {}
    void check_claim(double bytes_per_value) const;
    /// Chunks of one row each that went through the filters of new tables?
    bool is_packed_by_row() const;
    /// False where HDF5 has to read, or to say what is wrong.
    bool unpack_rows(std::size_t first, std::span<std::int16_t> values) const;
    bool append_chunk(std::size_t row, std::vector<std::uint8_t>& bytes) const;

    std::filesystem::path file_;
    std::string name_;
    std::int64_t handle_ = -1;
    TableShape shape_;
};

}  // namespace specula
