#pragma once

// What the tests need of HDF5 that the program does not: to look into files, and to make broken
// ones. Debian keeps the header in a folder of its own.
#if __has_include(<hdf5/serial/hdf5.h>)
#include <hdf5/serial/hdf5.h>
#define SPECULA_TEST_HAS_HDF5 1
#elif __has_include(<hdf5.h>)
#include <hdf5.h>
#define SPECULA_TEST_HAS_HDF5 1
#endif

#ifdef SPECULA_TEST_HAS_HDF5

#include <filesystem>
#include <string>
#include <vector>

namespace specula {

/// An open HDF5 file, to look into or to spoil.
class Hdf5Probe {
  public:
    explicit Hdf5Probe(const std::filesystem::path& file)
        : file_(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)) {}
    Hdf5Probe(const Hdf5Probe&) = delete;
    Hdf5Probe& operator=(const Hdf5Probe&) = delete;
    ~Hdf5Probe() { H5Fclose(file_); }

    void remove(const std::string& object) { H5Ldelete(file_, object.c_str(), H5P_DEFAULT); }
    void add_group(const std::string& object) {
        H5Gclose(H5Gcreate2(file_, object.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    }
    void remove_attribute(const std::string& object, const std::string& name) {
        H5Adelete_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT);
    }
    /// Replaces an attribute by numbers in a row.
    void put_numbers(const std::string& object, const std::string& name,
                     const std::vector<double>& values) {
        const hsize_t n = values.size();
        put(object, name, H5T_IEEE_F64LE, H5Screate_simple(1, &n, nullptr), values.data());
    }
    /// Replaces an attribute by text of variable length, as h5py writes it.
    void put_variable_text(const std::string& object, const std::string& name, const char* text) {
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, H5T_VARIABLE);
        put(object, name, type, H5Screate(H5S_SCALAR), &text);
        H5Tclose(type);
    }
    /// Replaces an attribute by texts of fixed length in a row.
    void put_texts(const std::string& object, const std::string& name,
                   const std::vector<std::string>& texts) {
        constexpr std::size_t length = 32;
        std::string packed;
        for (const std::string& text : texts) packed += text + std::string(length - text.size(), 0);
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, length);
        const hsize_t n = texts.size();
        put(object, name, type, H5Screate_simple(1, &n, nullptr), packed.data());
        H5Tclose(type);
    }
    /// Replaces a table by one of 16-bit numbers, chunked, never written.
    void put_claim(const std::string& object, const std::vector<hsize_t>& shape) {
        remove(object);
        const std::vector<hsize_t> chunk(shape.size(), 1);
        const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
        const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
        H5Dclose(H5Dcreate2(file_, object.c_str(), H5T_STD_I16LE, space, H5P_DEFAULT, creation,
                            H5P_DEFAULT));
        H5Sclose(space);
        H5Pclose(creation);
    }

    /// Adds to one number of a table of whole numbers of 64 bits.
    void add_number(const std::string& table, std::size_t row, std::uint64_t more) {
        const hid_t id = H5Dopen2(file_, table.c_str(), H5P_DEFAULT), space = H5Dget_space(id);
        std::vector<std::uint64_t> values(
            static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        H5Dread(id, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        values[row] += more;
        H5Dwrite(id, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        H5Sclose(space);
        H5Dclose(id);
    }
    /// A table that is neither chunked nor filtered.
    void add_plain_table(const std::string& object) {
        const hsize_t n = 3;
        const double values[] = {1.0, 2.0, 3.0};
        const hid_t space = H5Screate_simple(1, &n, nullptr);
        const hid_t id = H5Dcreate2(file_, object.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                    H5P_DEFAULT, H5P_DEFAULT);
        H5Dwrite(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
        H5Dclose(id);
        H5Sclose(space);
    }

    /// Of all objects below the root, in the order of their names.
    std::vector<std::string> objects() const {
        std::vector<std::string> names;
        H5Lvisit(
            file_, H5_INDEX_NAME, H5_ITER_INC,
            [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
                static_cast<std::vector<std::string>*>(to)->push_back(std::string("/") + name);
                return 0;
            },
            &names);
        return names;
    }
    std::vector<std::string> attributes(const std::string& object) const {
        std::vector<std::string> names;
        const hid_t id = H5Oopen(file_, object.c_str(), H5P_DEFAULT);
        H5Aiterate2(
            id, H5_INDEX_NAME, H5_ITER_INC, nullptr,
            [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
                static_cast<std::vector<std::string>*>(to)->push_back(name);
                return 0;
            },
            &names);
        H5Oclose(id);
        return names;
    }
    bool is_group(const std::string& object) const {
        const hid_t id = H5Oopen(file_, object.c_str(), H5P_DEFAULT);
        const bool group = H5Iget_type(id) == H5I_GROUP;
        H5Oclose(id);
        return group;
    }

    struct Layout {
        std::string type;            ///< "int16", "uint8", "float64", ...
        std::vector<hsize_t> chunk;  ///< empty: not chunked
        std::string filters;         ///< "shuffle, gzip 4, fletcher32"
        bool little_endian = false;
    };
    Layout layout(const std::string& table) const {
        Layout found;
        const hid_t id = H5Dopen2(file_, table.c_str(), H5P_DEFAULT);
        const hid_t type = H5Dget_type(id), creation = H5Dget_create_plist(id);
        const std::string bits = std::to_string(8 * H5Tget_size(type));
        found.type = H5Tget_class(type) == H5T_FLOAT     ? "float" + bits
                     : H5Tget_sign(type) == H5T_SGN_NONE ? "uint" + bits
                                                         : "int" + bits;
        found.little_endian = H5Tget_order(type) != H5T_ORDER_BE;
        found.chunk.resize(8);
        const int rank = H5Pget_chunk(creation, 8, found.chunk.data());
        found.chunk.resize(rank < 0 ? 0 : static_cast<std::size_t>(rank));
        for (int i = 0; i < H5Pget_nfilters(creation); ++i) {
            unsigned flags = 0, values[8] = {};
            std::size_t n_values = 8;
            const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags,
                                                       &n_values, values, 0, nullptr, nullptr);
            found.filters += found.filters.empty() ? "" : ", ";
            found.filters += filter == H5Z_FILTER_SHUFFLE      ? "shuffle"
                             : filter == H5Z_FILTER_DEFLATE    ? "gzip " + std::to_string(values[0])
                             : filter == H5Z_FILTER_FLETCHER32 ? "fletcher32"
                                                               : "another";
        }
        H5Pclose(creation);
        H5Tclose(type);
        H5Dclose(id);
        return found;
    }

  private:
    void put(const std::string& object, const std::string& name, hid_t type, hid_t space,
             const void* values) {
        remove_attribute(object, name);
        const hid_t attribute = H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space,
                                                  H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, type, values);
        H5Aclose(attribute);
        H5Sclose(space);
    }

    hid_t file_;
};

}  // namespace specula

#endif
