#include "sim/dataset/hdf5_index.hpp"

#include "sim/core/expect.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "sim/dataset/hdf5_library.hpp"

namespace specula {

namespace {

namespace fs = std::filesystem;

/// Copies every attribute of one object to the object of the same name in another file.
void copy_attributes(hid_t from, hid_t to) {
    H5Aiterate2(
        from, H5_INDEX_NAME, H5_ITER_INC, nullptr,
        [](hid_t object, const char* name, const H5A_info_t*, void* target) -> herr_t {
            const Hdf5Handle in(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
            const Hdf5Handle type(H5Aget_type(in), H5Tclose), space(H5Aget_space(in), H5Sclose);
            const auto n = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
            std::vector<char> values(n * H5Tget_size(type));
            const Hdf5Handle out(H5Acreate2(*static_cast<hid_t*>(target), name, type, space,
                                            H5P_DEFAULT, H5P_DEFAULT),
                                 H5Aclose);
            return H5Aread(in, type, values.data()) < 0 || H5Awrite(out, type, values.data()) < 0
                       ? -1
                       : 0;
        },
        &to);
}

/// The names of all objects below the root, parents first.
std::vector<std::string> object_names(hid_t file) {
    std::vector<std::string> names;
    H5Lvisit(
        file, H5_INDEX_NAME, H5_ITER_INC,
        [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
            static_cast<std::vector<std::string>*>(to)->push_back(name);
            return 0;
        },
        &names);
    return names;
}

/// A table that shows `name` of all files, one below the other.
Hdf5Handle virtual_table(hid_t index, hid_t model, const std::string& name,
                         const std::vector<IndexedFile>& files) {
    const Hdf5Handle type(H5Dget_type(model), H5Tclose), own(H5Dget_space(model), H5Sclose);
    std::vector<hsize_t> size(static_cast<std::size_t>(H5Sget_simple_extent_ndims(own)));
    H5Sget_simple_extent_dims(own, size.data(), nullptr);
    std::vector<hsize_t> whole = size;
    whole[0] = 0;
    for (const IndexedFile& file : files) whole[0] += file.n_rows;
    const auto rank = static_cast<int>(size.size());
    const Hdf5Handle space(H5Screate_simple(rank, whole.data(), nullptr), H5Sclose);
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);
    std::vector<hsize_t> start(size.size(), 0);
    for (const IndexedFile& file : files) {
        size[0] = file.n_rows;
        const Hdf5Handle rows(H5Screate_simple(rank, size.data(), nullptr), H5Sclose);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr);
        H5Pset_virtual(creation, space, file.name.c_str(), ("/" + name).c_str(), rows);
        start[0] += file.n_rows;
    }
    H5Sselect_all(space);
    return Hdf5Handle(
        H5Dcreate2(index, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
}

}  // namespace

void write_hdf5_index(const fs::path& index, const std::vector<IndexedFile>& files) {
    SPECULA_EXPECT(!files.empty());
    const fs::path first = index.parent_path() / files.front().name;
    Hdf5File out = Hdf5File::create(index);
    const Hdf5Handle model(H5Fopen(first.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    copy_attributes(model, out.handle());
    for (const std::string& name : object_names(model)) {
        if (name == "shard") continue;
        const Hdf5Handle object(H5Oopen(model, name.c_str(), H5P_DEFAULT), H5Oclose);
        if (H5Iget_type(object) == H5I_GROUP) {
            out.create_group("/" + name);
            continue;
        }
        const Hdf5Handle table = virtual_table(out.handle(), object, name, files);
        if (!table.valid()) hdf5_write_failed(index, name);
        copy_attributes(object, table);
    }
    out.publish();
}

}  // namespace specula
