#include "sim/dataset/hdf5_library.hpp"

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// One line of what HDF5 says; of the system's refusals, which it reports at length and with the
/// time of day, the system's own words.
std::string in_one_line(const std::string& description) {
    const std::string mark = "error message = '";
    const auto found = description.find(mark);
    if (found == std::string::npos) return description.substr(0, description.find('\n'));
    const auto begin = found + mark.size();
    return description.substr(begin, description.find('\'', begin) - begin);
}

}  // namespace

std::string last_hdf5_reason() {
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

void hdf5_write_failed(const std::filesystem::path& file, const std::string& object) {
    throw SystemError(format("{}: cannot write {}: {}", file.string(), object, last_hdf5_reason()));
}

void hdf5_read_failed(const std::filesystem::path& file, const std::string& object,
                      const std::string& problem) {
    throw InputError(format("{}: {}: {}; is it a dataset of this program, and whole?",
                            file.string(), object, problem));
}

void tame_hdf5() {
    static const bool tamed = [] {
        H5dont_atexit();
        H5open();
        H5PLset_loading_state(0);  // a file asks for no code of filters
        return true;
    }();
    thread_local const bool silenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
    (void)tamed;
    (void)silenced;
}

}  // namespace specula
