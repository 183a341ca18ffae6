#include "tools/report/gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
/// Has no name, so that nothing stays behind however the program ends.
using ScratchFile = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(std::string_view what, int reason) {
    throw SystemError(format("gnuplot: {}: {}", what, std::strerror(reason)));
}

ScratchFile scratch_file(std::string_view bytes = "") {
    ScratchFile file(std::tmpfile());
    if (!file) fail("cannot make a temporary file", errno);
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
        std::fflush(file.get()) != 0)
        fail("cannot write a temporary file", errno);
    std::rewind(file.get());
    return file;
}

std::string content(std::FILE* file) {
    std::string bytes;
    char block[65536];
    std::rewind(file);
    while (const std::size_t n = std::fread(block, 1, sizeof block, file)) bytes.append(block, n);
    if (std::ferror(file)) fail("cannot read a temporary file", errno);
    return bytes;
}

/// The parent's environment with one locale for all: decimal points and encodings never vary.
std::vector<char*> child_environment() {
    static char locale[] = "LC_ALL=C.UTF-8";
    std::vector<char*> variables{locale};
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (std::strncmp(*variable, "LC_ALL=", 7) != 0) variables.push_back(*variable);
    variables.push_back(nullptr);
    return variables;
}

struct Streams {
    std::FILE *in, *out, *errors;
};

/// Returns the wait status. The script is named as a file, /dev/stdin: when gnuplot merely reads
/// its standard input, it carries on after an error.
int run(const std::string& program, const Streams& streams) {
    char name[] = "gnuplot", defaults[] = "-d", script[] = "/dev/stdin";
    char* arguments[] = {name, defaults, script, nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(streams.in), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(streams.out), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(streams.errors), STDERR_FILENO);
    pid_t child = 0;
    const int reason = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments,
                                    child_environment().data());
    posix_spawn_file_actions_destroy(&actions);
    if (reason == ENOENT)
        throw SystemError(format(
            "{}: program not found; install gnuplot-nox (apt-get install gnuplot-nox)", program));
    if (reason != 0) fail(format("cannot start {}", program), reason);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) fail("cannot wait for it", errno);
    return status;
}

/// gnuplot prints the offending line, a caret, and then what is wrong with it.
std::string last_line(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

}  // namespace

std::string run_gnuplot(std::string_view script, const std::string& program) {
    const ScratchFile in = scratch_file(script), out = scratch_file(), errors = scratch_file();
    const int status = run(program, {in.get(), out.get(), errors.get()});
    if (WIFSIGNALED(status))
        throw SystemError(format("gnuplot: ended by signal {}", WTERMSIG(status)));
    if (WEXITSTATUS(status) != 0)
        throw SystemError(format("gnuplot: exit status {}: {}", WEXITSTATUS(status),
                                 last_line(content(errors.get()))));
    std::string picture = content(out.get());
    if (picture.empty())
        throw SystemError(format("gnuplot: drew nothing: {}", last_line(content(errors.get()))));
    return picture;
}

std::string gnuplot_quoted(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') quoted += '\'';
        quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    return quoted + "'";
}

}  // namespace specula
