#pragma once

#include <hdf5.h>

#include <filesystem>
#include <string>

namespace specula {

/// Closes what HDF5 opened.
class Hdf5Handle {
  public:
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    ~Hdf5Handle() {
        if (id_ >= 0) close_(id_);
    }
    operator hid_t() const { return id_; }
    bool valid() const { return id_ >= 0; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// The innermost reason on HDF5's error stack, in one line.
std::string last_hdf5_reason();

/// Throws SystemError `file: cannot write object: reason`.
[[noreturn]] void hdf5_write_failed(const std::filesystem::path& file, const std::string& object);

/// Throws InputError `file: object: problem`.
[[noreturn]] void hdf5_read_failed(const std::filesystem::path& file, const std::string& object,
                                   const std::string& problem);

/// Silences HDF5's own printing and its work at exit, which crashes after a failed write. Once,
/// and once in every thread: each has error reports of its own.
void tame_hdf5();

}  // namespace specula
