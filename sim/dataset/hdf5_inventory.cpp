#include <algorithm>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "sim/dataset/hdf5_guard.hpp"
#include "sim/dataset/hdf5_library.hpp"

// What a file holds, whatever its format: for comparing files and describing them.

namespace specula {

namespace {

constexpr std::size_t most_objects = 10000;  ///< a dataset has some thirty

struct Names {
    std::vector<std::string> all;
    std::string prefix;
    std::string damaged;  ///< the first object that cannot be read
    hid_t file;
};

herr_t note_link(hid_t, const char* name, const H5L_info_t* link, void* to);

/// Groups by hand rather than by H5Lvisit: that follows what we would not.
void walk_group(Names& names, const std::string& group) {
    const std::string before = names.prefix;
    names.prefix = group == "/" ? "/" : group + "/";
    const Hdf5Handle id(H5Gopen2(names.file, group.c_str(), H5P_DEFAULT), H5Gclose);
    const bool is_whole =
        id.valid() &&
        H5Literate(id, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_link, &names) >= 0;
    if (!is_whole && names.damaged.empty()) names.damaged = group;
    names.prefix = before;
}

herr_t note_link(hid_t, const char* name, const H5L_info_t* link, void* to) {
    Names& names = *static_cast<Names*>(to);
    const std::string path = names.prefix + name;
    if (link->type != H5L_TYPE_HARD || names.all.size() >= most_objects) return 0;
    const auto depth = std::count(path.begin(), path.end(), '/');
    H5O_info_t info;
    if (H5Oget_info_by_name(names.file, path.c_str(), &info, H5P_DEFAULT) < 0) {
        names.damaged = path;
        return -1;
    }
    if (info.type == H5O_TYPE_DATASET) names.all.push_back(path);
    if (info.type == H5O_TYPE_GROUP && depth < 8) walk_group(names, path);
    return 0;
}

}  // namespace

std::vector<std::string> Hdf5File::tables() const {
    Names names{.all = {}, .prefix = "", .damaged = {}, .file = handle_};
    walk_group(names, "/");
    if (!names.damaged.empty()) hdf5_read_failed(file_, names.damaged, "is damaged");
    return names.all;
}

bool Hdf5File::is_house_table(const std::string& table) const {
    return is_house_hdf5_table(handle_, table);
}

std::string Hdf5File::number_type(const std::string& table) const {
    const Hdf5Handle id(open_hdf5_table(handle_, file_, table), H5Dclose);
    const Hdf5Handle type(H5Dget_type(id), H5Tclose);
    const std::pair<hid_t, const char*> known[] = {
        {H5T_STD_I16LE, "int16"},  {H5T_STD_I32LE, "int32"},    {H5T_STD_U8LE, "uint8"},
        {H5T_STD_U64LE, "uint64"}, {H5T_IEEE_F32LE, "float32"}, {H5T_IEEE_F64LE, "float64"}};
    for (const auto& [candidate, name] : known)
        if (H5Tequal(type, candidate) > 0) return name;
    return "";
}

std::vector<std::string> Hdf5File::attributes(const std::string& object) const {
    std::vector<std::string> names;
    const Hdf5Handle id(H5Oopen(handle_, object.c_str(), H5P_DEFAULT), H5Oclose);
    if (!id.valid()) hdf5_read_failed(file_, object, "is missing");
    const herr_t walked = H5Aiterate2(
        id, H5_INDEX_NAME, H5_ITER_INC, nullptr,
        [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
            static_cast<std::vector<std::string>*>(to)->push_back(name);
            return 0;
        },
        &names);
    if (walked < 0) hdf5_read_failed(file_, object, "has damaged attributes");
    return names;
}

std::string Hdf5File::attribute_text(const std::string& object, const std::string& name) const {
    const Hdf5Handle attribute(
        H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(attribute.valid() ? H5Aget_type(attribute) : -1, H5Tclose);
    if (type.valid() && H5Tget_class(type) != H5T_STRING) return format("{}", number(object, name));
    std::string joined;
    for (const std::string& each : texts(object, name))
        joined += (joined.empty() ? "" : ",") + each;
    return joined;
}

}  // namespace specula
