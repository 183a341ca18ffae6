#include "sim/core/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "sim/core/error.hpp"
#include "sim/core/new_file.hpp"

namespace specula {

namespace {

constexpr const char* draft_mark = ".draft-";  ///< before the number of the process

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int error) {
    throw SystemError(path.string() + ": " + what + ": " + std::strerror(error));
}

/// What another name for the output would mend; all else is the machine's.
bool is_about_the_place(int error) {
    for (const int each :
         {ENOENT, ENOTDIR, EACCES, EPERM, EROFS, EISDIR, EEXIST, ENAMETOOLONG, ELOOP, EINVAL})
        if (error == each) return true;
    return false;
}

[[noreturn]] void fail_to_create(const std::filesystem::path& path, int error) {
    if (!is_about_the_place(error)) fail(path, "cannot create", error);
    throw InputError(path.string() + ": cannot create: " + std::strerror(error) +
                     "; give another place");
}

/// Repeats a system call that a signal interrupted.
template <typename Call>
auto uninterrupted(Call call) {
    auto result = call();
    while (result == -1 && errno == EINTR) result = call();
    return result;
}

/// A file that is removed unless it got its final name.
class Draft {
  public:
    explicit Draft(const std::filesystem::path& file) {
        static std::atomic<unsigned> n_drafts{0};
        do {  // a name may be taken: left by a process of the same id that was killed
            path_ = file;
            path_ += draft_mark + std::to_string(::getpid()) + "-" + std::to_string(n_drafts++);
            descriptor_ = uninterrupted([&] {
                return ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            });
        } while (descriptor_ == -1 && errno == EEXIST);
        if (descriptor_ == -1) fail_to_create(file, errno);
        ::flock(descriptor_, LOCK_EX | LOCK_NB);  // what no lock is on may be cleared away
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        if (descriptor_ != -1) ::close(descriptor_);
        if (!in_place_) ::unlink(path_.c_str());
    }

    void write(std::string_view content) {
        while (!content.empty()) {
            const ssize_t n =
                uninterrupted([&] { return ::write(descriptor_, content.data(), content.size()); });
            if (n == -1) fail(path_, "cannot write", errno);
            content.remove_prefix(static_cast<std::size_t>(n));
        }
    }

    void close_on_disk() {
        if (uninterrupted([&] { return ::fsync(descriptor_); }) == -1)
            fail(path_, "cannot bring to the disk", errno);
        const int result = ::close(descriptor_);
        descriptor_ = -1;
        // Interrupted or not, Linux has released the descriptor, and the data is on the disk.
        if (result == -1 && errno != EINTR) fail(path_, "cannot close", errno);
    }

    void put_in_place(const std::filesystem::path& file) {
        if (::rename(path_.c_str(), file.c_str()) == -1) fail(file, "cannot replace", errno);
        in_place_ = true;
    }

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    bool in_place_ = false;
};

/// Brings the new name to the disk.
void sync_folder(const std::filesystem::path& folder) {
    const int descriptor =
        uninterrupted([&] { return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
    if (descriptor == -1) fail(folder, "cannot open", errno);
    const int result = uninterrupted([&] { return ::fsync(descriptor); });
    const int error = errno;
    ::close(descriptor);
    // Some network file systems know no fsync of a folder.
    if (result == -1 && error != EINVAL) fail(folder, "cannot bring to the disk", error);
}

/// Brings a finished file to the disk.
void sync_content(const std::filesystem::path& file) {
    const int descriptor =
        uninterrupted([&] { return ::open(file.c_str(), O_RDONLY | O_CLOEXEC); });
    if (descriptor == -1) fail(file, "cannot open", errno);
    const int result = uninterrupted([&] { return ::fsync(descriptor); });
    const int error = errno;
    ::close(descriptor);
    if (result == -1) fail(file, "cannot bring to the disk", error);
}

/// rename() that replaces nothing; false with errno where it does not succeed.
bool rename_to_new(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        return true;
    // Some network file systems know no such flag, but links, which replace nothing either.
    if (errno != EINVAL && errno != ENOSYS) return false;
    if (::link(from.c_str(), to.c_str()) == -1) return false;
    ::unlink(from.c_str());
    return true;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// Whether a draft is of no living process of this machine, and of none of another that shares the
/// folder: whoever writes one holds a lock on it.
bool is_abandoned(const std::filesystem::path& draft, int process) {
    if (process <= 0 || ::kill(process, 0) == 0 || errno != ESRCH) return false;
    const int descriptor = ::open(draft.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor == -1) return false;
    const bool is_free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    ::close(descriptor);
    return is_free;
}

}  // namespace

std::filesystem::path place_of_file(const std::filesystem::path& name) {
    constexpr int most_links = 40;  // as many as Linux follows
    std::error_code error;
    const auto status = std::filesystem::status(name, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError(name.string() + ": is there, and is no file; give another name");
    std::filesystem::path place = name;
    for (int i = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(place, error));
         ++i) {
        if (i == most_links) fail(name, "cannot follow", ELOOP);
        const auto target = std::filesystem::read_symlink(place, error);
        if (error) fail(name, "cannot follow", error.value());
        place = target.is_absolute() ? target : folder_of(place) / target;
    }
    return place;
}

void remove_abandoned_drafts(const std::filesystem::path& file) {
    const std::filesystem::path place = place_of_file(file);
    const std::string mark = place.filename().string() + draft_mark;
    std::error_code ignored;
    std::vector<std::filesystem::path> drafts;
    for (const auto& entry : std::filesystem::directory_iterator(folder_of(place), ignored)) {
        const std::string name = entry.path().filename().string();
        if (name.rfind(mark, 0) == 0 &&
            is_abandoned(entry.path(), std::atoi(name.c_str() + mark.size())))
            drafts.push_back(entry.path());
    }
    for (const auto& draft : drafts) std::filesystem::remove(draft, ignored);
}

void make_output_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) fail_to_create(folder, error.value());
    // A link or a file of that name is no error to the library.
    if (!std::filesystem::is_directory(folder, error)) fail_to_create(folder, ENOTDIR);
}

void check_output_place(const std::filesystem::path& file) {
    const std::filesystem::path place = place_of_file(file);
    make_output_folder(folder_of(place));
    const Draft draft(place);
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
    const std::filesystem::path place = place_of_file(file);
    make_output_folder(folder_of(place));
    Draft draft(place);
    draft.write(content);
    draft.close_on_disk();
    draft.put_in_place(place);
    sync_folder(folder_of(place));
}

void publish_file(const std::filesystem::path& draft, const std::filesystem::path& file) {
    const std::filesystem::path place = place_of_file(file);
    sync_content(draft);
    if (::rename(draft.c_str(), place.c_str()) == -1) fail(place, "cannot replace", errno);
    sync_folder(folder_of(place));
}

void publish_new_file(const std::filesystem::path& draft, const std::filesystem::path& file) {
    const std::filesystem::path place = place_of_file(file);
    sync_content(draft);
    if (!rename_to_new(draft, place)) {
        if (errno != EEXIST) fail(place, "cannot create", errno);
        throw InputError(file.string() +
                         ": was made by another process meanwhile, and stays as that made it; give "
                         "another name");
    }
    sync_folder(folder_of(place));
}

}  // namespace specula
