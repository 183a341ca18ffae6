#include "sim/core/output_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

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

int operation_of(OutputLock::Kind kind) {
    switch (kind) {
        case OutputLock::Kind::alone: return LOCK_EX | LOCK_NB;
        case OutputLock::Kind::beside_others: return LOCK_SH | LOCK_NB;
        case OutputLock::Kind::in_turn: return LOCK_EX;
    }
    throw std::logic_error("OutputLock: unknown kind");
}

/// 0 or -1, as flock says; a signal does not end the waiting.
int lock(int descriptor, OutputLock::Kind kind) {
    int outcome = 0;
    do {
        outcome = ::flock(descriptor, operation_of(kind));
    } while (outcome == -1 && errno == EINTR);
    return outcome;
}

}  // namespace

OutputLock::OutputLock(const std::filesystem::path& file, Kind kind)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor_ == -1)
        throw SystemError(file.string() + ": cannot create: " + std::strerror(errno));
    if (lock(descriptor_, kind) == -1) {
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
