#include "tools/specula/printed_output.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "sim/core/error.hpp"

namespace specula {

namespace {

/// Whether nobody reads what is printed any more. An earlier, larger piece may have met the closed
/// pipe; what then became of errno says nothing.
bool reader_has_gone() {
    pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
    return ::poll(&output, 1, 0) == 1 && (output.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace

void flush_printed_output() {
    errno = 0;
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return;
    if (errno == EPIPE || reader_has_gone()) return;
    throw SystemError(std::string("standard output: cannot write: ") +
                      (errno == 0 ? "a part is lost" : std::strerror(errno)));
}

}  // namespace specula
