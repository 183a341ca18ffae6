#include "tools/serve/interruption.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>

#include "sim/core/error.hpp"

namespace specula {

namespace {

int told = -1;  // a signal reaches nothing but what is global

void tell(int) {
    const std::uint64_t one = 1;
    const int before = errno;
    [[maybe_unused]] const auto written = ::write(told, &one, sizeof one);
    errno = before;
}

}  // namespace

Interruption::Interruption() {
    told = ::eventfd(0, EFD_CLOEXEC);
    if (told < 0) throw SystemError("the system: has no file descriptor left");
    std::signal(SIGINT, tell);
    std::signal(SIGTERM, tell);
}

Interruption::~Interruption() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    ::close(told);
}

void Interruption::wait() const {
    std::uint64_t count = 0;
    while (::read(told, &count, sizeof count) < 0 && errno == EINTR) {
    }
}

}  // namespace specula
