#include "tools/firmware/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string last_line_of(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

/// A pipe whose ends close with it.
struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (::pipe2(ends, O_CLOEXEC) != 0)
            throw SystemError(format("pipe: {}", std::strerror(errno)));
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_writer();
        ::close(ends[0]);
    }
    void close_writer() {
        if (ends[1] >= 0) ::close(ends[1]);
        ends[1] = -1;
    }
};

pid_t start(const Command& command, int output) {
    std::vector<char*> arguments;
    std::vector<std::string> words = command.words;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (!command.folder.empty())
        posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    pid_t child = 0;
    const int reason =
        ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (reason == ENOENT)
        throw SystemError(format("{}: program not found; {}", command.words[0],
                                 command.remedy.empty() ? format("install {} (apt-get install {})",
                                                                 command.package, command.package)
                                                        : command.remedy));
    if (reason != 0)
        throw SystemError(
            format("{}: cannot be started: {}", command.words[0], std::strerror(reason)));
    return child;
}

std::string read_all(int file) {
    std::string text;
    char block[4096];
    for (;;) {
        const ssize_t n = ::read(file, block, sizeof block);
        if (n > 0) text.append(block, static_cast<std::size_t>(n));
        if (n == 0 || (n < 0 && errno != EINTR)) return text;
    }
}

}  // namespace

Finished run_program_and_wait(const Command& command) {
    Pipe pipe;
    const pid_t child = start(command, pipe.ends[1]);
    pipe.close_writer();
    Finished finished;
    finished.output = read_all(pipe.ends[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            throw SystemError(
                format("{}: cannot wait for it: {}", command.words[0], std::strerror(errno)));
    finished.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    return finished;
}

std::string output_of(const Command& command) {
    const Finished finished = run_program_and_wait(command);
    if (finished.status != 0)
        throw SystemError(format("{}: exit status {}: {}", command.words[0], finished.status,
                                 last_line_of(finished.output)));
    return finished.output;
}

}  // namespace specula
