#include "sim/dataset/hdf5_file.hpp"

#include <unistd.h>

#include <algorithm>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/core/new_file.hpp"
#include "sim/dataset/hdf5_guard.hpp"
#include "sim/dataset/hdf5_number.hpp"

namespace specula {

namespace {

Hdf5Handle v110_access() {
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    return Hdf5Handle(H5Pcopy(access), H5Pclose);
}

void write_attribute(hid_t file, const std::filesystem::path& path, const std::string& object,
                     const std::string& name, hid_t type, hid_t space, const void* values) {
    const Hdf5Handle attribute(H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space,
                                                 H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                               H5Aclose);
    if (!attribute.valid() || H5Awrite(attribute, type, values) < 0)
        hdf5_write_failed(path, object + "@" + name);
}

Hdf5Handle text_type(std::size_t size) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, std::max<std::size_t>(1, size));
    H5Tset_cset(type, H5T_CSET_UTF8);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return Hdf5Handle(H5Tcopy(type), H5Tclose);
}

/// Beyond eight attributes or links, HDF5 keeps an object's in a heap without checksums, where a
/// flipped bit is read as text; in its header they have one. No object of ours has as many as this.
void keep_compact(hid_t creation) {
    constexpr unsigned most = 64, fewest_in_a_heap = 0;
    H5Pset_attr_phase_change(creation, most, fewest_in_a_heap);
    H5Pset_link_phase_change(creation, most, fewest_in_a_heap);
}

}  // namespace

Hdf5File Hdf5File::create(const std::filesystem::path& file) {
    tame_hdf5();
    const std::filesystem::path draft =
        place_of_file(file).string() + format(".draft-{}", ::getpid());
    // Nothing that needs a superblock extension, such as a file space strategy: HDF5 stores the
    // time in that, whatever it is told.
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);
    keep_compact(creation);
    const Hdf5Handle access = v110_access();
    const hid_t id = H5Fcreate(draft.c_str(), H5F_ACC_TRUNC, creation, access);
    if (id < 0) {
        const std::string reason = last_hdf5_reason();
        ::unlink(draft.c_str());
        throw SystemError(format("{}: cannot create: {}", file.string(), reason));
    }
    return Hdf5File(file, draft, id);
}

Hdf5File Hdf5File::open(const std::filesystem::path& file) {
    tame_hdf5();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        throw InputError(file.string() + (std::filesystem::exists(file, ignored)
                                              ? ": is no regular file; name a dataset (.h5)"
                                              : ": no such file; check the path"));
    check_hdf5_superblock(file);
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (id < 0) hdf5_read_failed(file, "file", "cannot be opened as HDF5: " + last_hdf5_reason());
    return Hdf5File(file, {}, id);
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : file_(std::move(other.file_)), draft_(std::move(other.draft_)), handle_(other.handle_) {
    other.handle_ = -1;
    other.draft_.clear();
}

Hdf5File::~Hdf5File() {
    if (handle_ >= 0) H5Fclose(handle_);
    if (!draft_.empty()) ::unlink(draft_.c_str());
}

void Hdf5File::create_group(const std::string& name) {
    const Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);
    keep_compact(creation);
    const Hdf5Handle group(H5Gcreate2(handle_, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT),
                           H5Gclose);
    if (!group.valid()) hdf5_write_failed(file_, name);
}

template <typename T>
Hdf5Table Hdf5File::create_table(const std::string& name, TableShape shape) {
    const T* type_of = nullptr;
    std::vector<hsize_t> size(shape.size.begin(), shape.size.end()), chunk = size;
    chunk[0] = std::clamp<hsize_t>(shape.rows_per_chunk, 1, std::max<hsize_t>(1, size[0]));
    shape.rows_per_chunk = chunk[0];
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                           H5Sclose);
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 4);
    H5Pset_fletcher32(creation);
    H5Pset_obj_track_times(creation, false);
    const hid_t table = H5Dcreate2(handle_, name.c_str(), file_type(type_of), space, H5P_DEFAULT,
                                   creation, H5P_DEFAULT);
    if (table < 0) hdf5_write_failed(file_, name);
    return Hdf5Table(file_, name, table, std::move(shape));
}

template <typename T>
void Hdf5File::write(const std::string& name, const std::vector<std::size_t>& shape,
                     std::size_t rows_per_chunk, const std::vector<T>& values) {
    Hdf5Table table = create_table<T>(name, {shape, rows_per_chunk});
    SPECULA_EXPECT(values.size() == shape[0] * TableShape{shape}.values_per_row());
    table.write_rows<T>(0, values);
}

Hdf5Table Hdf5File::table(const std::string& name) const {
    const hid_t table = open_hdf5_table(handle_, file_, name);
    Hdf5Table opened(file_, name, table, {});
    const Hdf5Handle space(H5Dget_space(table), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 1 || rank > 8) hdf5_read_failed(file_, name, "has an odd shape");
    std::vector<hsize_t> size(static_cast<std::size_t>(rank)), chunk(size.size(), 1);
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
    const Hdf5Handle creation(H5Dget_create_plist(table), H5Pclose);
    if (H5Pget_layout(creation) == H5D_CHUNKED) H5Pget_chunk(creation, rank, chunk.data());
    opened.shape_ = {{size.begin(), size.end()}, chunk[0]};
    return opened;
}

template <typename T>
std::vector<T> Hdf5File::read(const std::string& name) const {
    const Hdf5Table rows = table(name);
    return rows.read_rows<T>(0, rows.size()[0]);
}

#define SPECULA_HDF5_TYPE(T)                                                              \
    template Hdf5Table Hdf5File::create_table<T>(const std::string&, TableShape);         \
    template void Hdf5File::write<T>(const std::string&, const std::vector<std::size_t>&, \
                                     std::size_t, const std::vector<T>&);                 \
    template std::vector<T> Hdf5File::read<T>(const std::string&) const;
SPECULA_HDF5_TYPE(std::int16_t)
SPECULA_HDF5_TYPE(std::int32_t)
SPECULA_HDF5_TYPE(std::uint64_t)
SPECULA_HDF5_TYPE(std::uint8_t)
SPECULA_HDF5_TYPE(float)
SPECULA_HDF5_TYPE(double)
#undef SPECULA_HDF5_TYPE

void Hdf5File::set_text(const std::string& object, const std::string& name,
                        const std::string& text) {
    const Hdf5Handle type = text_type(text.size());
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const std::string padded = text.empty() ? std::string(1, '\0') : text;
    write_attribute(handle_, file_, object, name, type, space, padded.data());
}

void Hdf5File::set_number(const std::string& object, const std::string& name, double value) {
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    write_attribute(handle_, file_, object, name, H5T_IEEE_F64LE, space, &value);
}

void Hdf5File::set_texts(const std::string& object, const std::string& name,
                         const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string packed;
    for (const std::string& text : texts) packed += text + std::string(longest - text.size(), '\0');
    const Hdf5Handle type = text_type(longest);
    const hsize_t n = texts.size();
    const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
    write_attribute(handle_, file_, object, name, type, space, packed.data());
}

std::vector<std::size_t> Hdf5File::shape(const std::string& name) const {
    return table(name).size();
}

std::vector<std::string> Hdf5File::groups() const {
    std::vector<std::string> names;
    H5G_info_t root;
    H5Gget_info(handle_, &root);
    for (hsize_t i = 0; i < root.nlinks; ++i) {
        char name[256] = {};
        H5Lget_name_by_idx(handle_, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name,
                           H5P_DEFAULT);
        const Hdf5Handle group(H5Gopen2(handle_, name, H5P_DEFAULT), H5Gclose);
        if (group.valid()) names.push_back(name);
    }
    return names;
}

std::vector<std::string> Hdf5File::texts(const std::string& object, const std::string& name) const {
    const std::string what = object + "@" + name;
    const Hdf5Handle attribute(
        H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.valid()) hdf5_read_failed(file_, what, "is missing");
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    const bool is_text = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    const std::size_t length = H5Tget_size(type);
    if (!is_text || n < 1 || n > 4096 || length > (1u << 22))
        hdf5_read_failed(file_, what, "is not text of fixed length");
    std::string packed(static_cast<std::size_t>(n) * length, '\0');
    if (H5Aread(attribute, type, packed.data()) < 0)
        hdf5_read_failed(file_, what, "cannot be read: " + last_hdf5_reason());
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        std::string text = packed.substr(i * length, length);
        text.erase(std::min(text.find('\0'), text.size()));
        texts.push_back(text);
    }
    return texts;
}

std::string Hdf5File::text(const std::string& object, const std::string& name) const {
    return texts(object, name)[0];
}

double Hdf5File::number(const std::string& object, const std::string& name) const {
    const Hdf5Handle attribute(
        H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.valid()) hdf5_read_failed(file_, object + "@" + name, "is missing");
    const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
    double value = 0.0;
    if (H5Sget_simple_extent_npoints(space) != 1 ||
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
        hdf5_read_failed(file_, object + "@" + name, "is not a number");
    return value;
}

void Hdf5File::close_draft() {
    const herr_t closed = H5Fclose(handle_);
    handle_ = -1;
    if (closed < 0) hdf5_write_failed(file_, "file");
}

void Hdf5File::publish() {
    close_draft();
    publish_file(draft_, file_);
    draft_.clear();
}

void Hdf5File::publish_new() {
    close_draft();
    publish_new_file(draft_, file_);
    draft_.clear();
}

}  // namespace specula
