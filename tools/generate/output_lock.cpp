#include "tools/generate/output_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string own_name() {
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    return format("process {} on {}", ::getpid(), host);
}

std::string holder_of(int descriptor) {
    char text[400] = {};
    const ssize_t n = ::pread(descriptor, text, sizeof text - 1, 0);
    return n > 0 ? std::string(text, static_cast<std::size_t>(n)) : "another process";
}

}  // namespace

OutputLock::OutputLock(const std::filesystem::path& file, Kind kind)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor_ == -1)
        throw SystemError(file.string() + ": cannot create: " + std::strerror(errno));
    if (::flock(descriptor_, (kind == Kind::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == -1) {
        const int error = errno;
        const std::string holder = holder_of(descriptor_);
        ::close(descriptor_);
        if (error != EWOULDBLOCK)
            throw SystemError(file.string() + ": cannot lock: " + std::strerror(error));
        throw InputError(format("{}: {} is writing here; wait for it, or stop it first",
                                file.parent_path().string(), holder));
    }
    const std::string name = own_name();
    if (::ftruncate(descriptor_, 0) == -1 ||
        ::pwrite(descriptor_, name.data(), name.size(), 0) == -1) {
        const int error = errno;
        ::close(descriptor_);
        throw SystemError(file.string() + ": cannot write: " + std::strerror(error));
    }
}

OutputLock::~OutputLock() {
    ::close(descriptor_);
}

}  // namespace specula
