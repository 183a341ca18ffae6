#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/dataset/hdf5_table.hpp"

namespace specula {

/// The one door to HDF5: tables of numbers with text beside them, in the house format: version 1.10
/// objects, chunks of one row or one block, shuffle + gzip + fletcher32, no times (the same content
/// gives the same bytes), fixed-length text, no links but hard ones.
///
/// One thread at a time. Every failure names the file and the object.
class Hdf5File {
  public:
    /// A new file under a temporary name beside `file`; `publish` gives it its name. Throws
    /// SystemError.
    static Hdf5File create(const std::filesystem::path& file);
    /// Throws InputError when it is not such a file.
    static Hdf5File open(const std::filesystem::path& file);

    Hdf5File(Hdf5File&& other) noexcept;
    Hdf5File& operator=(Hdf5File&&) = delete;
    ~Hdf5File();  ///< an unpublished file is removed

    void create_group(const std::string& name);
    /// A table to be filled by and by.
    template <typename T>
    Hdf5Table create_table(const std::string& name, TableShape shape);
    /// A table of `shape`, one chunk per `rows_per_chunk` rows, filled at once.
    template <typename T>
    void write(const std::string& name, const std::vector<std::size_t>& shape,
               std::size_t rows_per_chunk, const std::vector<T>& values);
    void set_text(const std::string& object, const std::string& name, const std::string& text);
    void set_number(const std::string& object, const std::string& name, double value);
    void set_texts(const std::string& object, const std::string& name,
                   const std::vector<std::string>& texts);

    Hdf5Table table(const std::string& name) const;
    std::vector<std::size_t> shape(const std::string& name) const;
    template <typename T>
    std::vector<T> read(const std::string& name) const;
    /// Names of the groups right below the root.
    std::vector<std::string> groups() const;
    std::string text(const std::string& object, const std::string& name) const;
    double number(const std::string& object, const std::string& name) const;
    std::vector<std::string> texts(const std::string& object, const std::string& name) const;

    /// For the other files of this door.
    std::int64_t handle() const { return handle_; }
    /// Paths of all tables, in the order of their names; what soft or external links lead to is
    /// not named.
    std::vector<std::string> tables() const;
    /// Whether a table is stored as this program stores tables; reading another one is refused.
    bool is_house_table(const std::string& table) const;
    /// "int16", "int32", "uint8", "uint64", "float32" or "float64"; empty: another type.
    std::string number_type(const std::string& table) const;
    /// Names of an object's attributes, in order.
    std::vector<std::string> attributes(const std::string& object) const;
    /// Any attribute as text: itself, its number, or several parted by commas.
    std::string attribute_text(const std::string& object, const std::string& name) const;

    /// Closes the file, brings it to the disk and puts it under its name. Throws SystemError.
    void publish();
    /// The same, but throws InputError where a file of that name appeared meanwhile, which stays.
    void publish_new();

  private:
    void close_draft();
    Hdf5File(std::filesystem::path file, std::filesystem::path draft, std::int64_t handle)
        : file_(std::move(file)), draft_(std::move(draft)), handle_(handle) {}

    std::filesystem::path file_;
    std::filesystem::path draft_;  ///< empty when opened for reading or published
    std::int64_t handle_ = -1;
};

}  // namespace specula
