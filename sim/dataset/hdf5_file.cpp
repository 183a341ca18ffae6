#include "sim/dataset/hdf5_file.hpp"

#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <numeric>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Closes what HDF5 opened.
class Handle {
  public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    operator hid_t() const { return id_; }
    bool valid() const { return id_ >= 0; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// One line of what HDF5 says; of the system's refusals, which it reports at length and with the
/// time of day, the system's own words.
std::string in_one_line(const std::string& description) {
    const std::string mark = "error message = '";
    const auto found = description.find(mark);
    if (found == std::string::npos) return description.substr(0, description.find('\n'));
    const auto begin = found + mark.size();
    return description.substr(begin, description.find('\'', begin) - begin);
}

/// The innermost reason on HDF5's error stack.
std::string last_reason() {
    std::string reason = "unknown reason";
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned depth, const H5E_error2_t* error, void* text) -> herr_t {
            if (depth == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
            return 0;
        },
        &reason);
    return in_one_line(reason);
}

[[noreturn]] void write_failed(const std::filesystem::path& file, const std::string& object) {
    throw SystemError(format("{}: cannot write {}: {}", file.string(), object, last_reason()));
}

[[noreturn]] void read_failed(const std::filesystem::path& file, const std::string& object,
                              const std::string& problem) {
    throw InputError(format("{}: {}: {}; is it a dataset of this program, and whole?",
                            file.string(), object, problem));
}

/// Silences HDF5's own printing and its work at exit, which crashes after a failed write.
void tame_library() {
    static const bool tamed = [] {
        H5dont_atexit();
        H5open();
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        return true;
    }();
    (void)tamed;
}

Handle v110_access() {
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
    return Handle(H5Pcopy(access), H5Pclose);
}

hid_t memory_type(const std::int16_t*) { return H5T_NATIVE_INT16; }
hid_t memory_type(const std::int32_t*) { return H5T_NATIVE_INT32; }
hid_t memory_type(const std::uint8_t*) { return H5T_NATIVE_UINT8; }
hid_t memory_type(const float*) { return H5T_NATIVE_FLOAT; }
hid_t memory_type(const double*) { return H5T_NATIVE_DOUBLE; }
hid_t file_type(const std::int16_t*) { return H5T_STD_I16LE; }
hid_t file_type(const std::int32_t*) { return H5T_STD_I32LE; }
hid_t file_type(const std::uint8_t*) { return H5T_STD_U8LE; }
hid_t file_type(const float*) { return H5T_IEEE_F32LE; }
hid_t file_type(const double*) { return H5T_IEEE_F64LE; }

void write_attribute(hid_t file, const std::filesystem::path& path, const std::string& object,
                     const std::string& name, hid_t type, hid_t space, const void* values) {
    const Handle attribute(
        H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT,
                          H5P_DEFAULT),
        H5Aclose);
    if (!attribute.valid() || H5Awrite(attribute, type, values) < 0)
        write_failed(path, object + "@" + name);
}

/// gzip makes nothing smaller than a 1032nd; a table that claims more was not written in full.
constexpr double best_compression = 1100.0;

std::size_t product(const std::vector<std::size_t>& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Handle text_type(std::size_t size) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, std::max<std::size_t>(1, size));
    H5Tset_cset(type, H5T_CSET_UTF8);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return Handle(H5Tcopy(type), H5Tclose);
}

}  // namespace

Hdf5File Hdf5File::create(const std::filesystem::path& file) {
    tame_library();
    const std::filesystem::path draft = file.string() + format(".draft-{}", ::getpid());
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);
    H5Pset_file_space_strategy(creation, H5F_FSPACE_STRATEGY_NONE, false, 1);
    const Handle access = v110_access();
    const hid_t id = H5Fcreate(draft.c_str(), H5F_ACC_TRUNC, creation, access);
    if (id < 0) {
        const std::string reason = last_reason();
        ::unlink(draft.c_str());
        throw SystemError(format("{}: cannot create: {}", file.string(), reason));
    }
    return Hdf5File(file, draft, id);
}

Hdf5File Hdf5File::open(const std::filesystem::path& file) {
    tame_library();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        throw InputError(file.string() + ": no such file; check the path");
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (id < 0) read_failed(file, "file", "cannot be opened as HDF5: " + last_reason());
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
    const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);
    const Handle group(H5Gcreate2(handle_, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT),
                       H5Gclose);
    if (!group.valid()) write_failed(file_, name);
}

template <typename T>
void Hdf5File::write(const std::string& name, const std::vector<std::size_t>& shape,
                     std::size_t rows_per_chunk, const std::vector<T>& values) {
    const T* type_of = nullptr;
    SPECULA_EXPECT(values.size() == product(shape));
    std::vector<hsize_t> size(shape.begin(), shape.end()), chunk = size;
    chunk[0] = std::clamp<hsize_t>(rows_per_chunk, 1, std::max<hsize_t>(1, size[0]));
    const Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr),
                       H5Sclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 4);
    H5Pset_fletcher32(creation);
    H5Pset_obj_track_times(creation, false);
    const Handle table(H5Dcreate2(handle_, name.c_str(), file_type(type_of), space, H5P_DEFAULT,
                                  creation, H5P_DEFAULT),
                       H5Dclose);
    if (!table.valid() || H5Dwrite(table, memory_type(type_of), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                   values.data()) < 0)
        write_failed(file_, name);
}

template <typename T>
std::vector<T> Hdf5File::read(const std::string& name) const {
    const T* type_of = nullptr;
    const std::vector<std::size_t> size = shape(name);
    const Handle table(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle type(H5Dget_type(table), H5Tclose);
    if (H5Tequal(type, file_type(type_of)) <= 0)
        read_failed(file_, name, "holds another type of number");
    double bytes = sizeof(T);
    for (const std::size_t n : size) bytes *= static_cast<double>(n);
    if (bytes > best_compression * static_cast<double>(H5Dget_storage_size(table)))
        read_failed(file_, name, "is larger than what the file holds of it");
    std::vector<T> values(product(size));
    if (H5Dread(table, memory_type(type_of), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        read_failed(file_, name, "cannot be read: " + last_reason());
    return values;
}

#define SPECULA_HDF5_TYPE(T)                                                                   \
    template void Hdf5File::write<T>(const std::string&, const std::vector<std::size_t>&,      \
                                     std::size_t, const std::vector<T>&);                      \
    template std::vector<T> Hdf5File::read<T>(const std::string&) const;
SPECULA_HDF5_TYPE(std::int16_t)
SPECULA_HDF5_TYPE(std::int32_t)
SPECULA_HDF5_TYPE(std::uint8_t)
SPECULA_HDF5_TYPE(float)
SPECULA_HDF5_TYPE(double)
#undef SPECULA_HDF5_TYPE

void Hdf5File::set_text(const std::string& object, const std::string& name,
                        const std::string& text) {
    const Handle type = text_type(text.size());
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const std::string padded = text.empty() ? std::string(1, '\0') : text;
    write_attribute(handle_, file_, object, name, type, space, padded.data());
}

void Hdf5File::set_number(const std::string& object, const std::string& name, double value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    write_attribute(handle_, file_, object, name, H5T_IEEE_F64LE, space, &value);
}

void Hdf5File::set_texts(const std::string& object, const std::string& name,
                         const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string packed;
    for (const std::string& text : texts)
        packed += text + std::string(longest - text.size(), '\0');
    const Handle type = text_type(longest);
    const hsize_t n = texts.size();
    const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
    write_attribute(handle_, file_, object, name, type, space, packed.data());
}

std::vector<std::size_t> Hdf5File::shape(const std::string& name) const {
    const Handle table(H5Dopen2(handle_, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!table.valid()) read_failed(file_, name, "is missing");
    const Handle space(H5Dget_space(table), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 1 || rank > 8) read_failed(file_, name, "has an odd shape");
    std::vector<hsize_t> size(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
    return {size.begin(), size.end()};
}

std::vector<std::string> Hdf5File::texts(const std::string& object, const std::string& name) const {
    const std::string what = object + "@" + name;
    const Handle attribute(
        H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.valid()) read_failed(file_, what, "is missing");
    const Handle type(H5Aget_type(attribute), H5Tclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
    const bool is_text = H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
    const hssize_t n = H5Sget_simple_extent_npoints(space);
    const std::size_t length = H5Tget_size(type);
    if (!is_text || n < 1 || n > 4096 || length > (1u << 22))
        read_failed(file_, what, "is not text of fixed length");
    std::string packed(static_cast<std::size_t>(n) * length, '\0');
    if (H5Aread(attribute, type, packed.data()) < 0)
        read_failed(file_, what, "cannot be read: " + last_reason());
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
    const Handle attribute(
        H5Aopen_by_name(handle_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (!attribute.valid()) read_failed(file_, object + "@" + name, "is missing");
    const Handle space(H5Aget_space(attribute), H5Sclose);
    double value = 0.0;
    if (H5Sget_simple_extent_npoints(space) != 1 ||
        H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
        read_failed(file_, object + "@" + name, "is not a number");
    return value;
}

void Hdf5File::publish() {
    const herr_t closed = H5Fclose(handle_);
    handle_ = -1;
    if (closed < 0) write_failed(file_, "file");
    publish_file(draft_, file_);
    draft_.clear();
}

}  // namespace specula
