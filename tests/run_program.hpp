#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/made_up_folder.hpp"

namespace specula {

/// What a program left behind when it ended.
struct Ended {
    int status = -1;  ///< exit status; 128 + signal where one killed it
    std::string output;
    std::string errors;
};

/// How a program is started.
struct Start {
    std::vector<std::string> arguments;  ///< the program first
    std::filesystem::path folder = ".";  ///< to work in
    std::map<std::string, std::string> environment{};  ///< on top of our own
    std::string output_file{};                         ///< instead of capturing standard output
};

/// Runs a program to its end, with nothing on its standard input.
inline Ended run_program(const Start& start) {
    const TemporaryFolder captured;
    const std::string output = start.output_file.empty() ? (captured / "output").string()
                                                         : start.output_file;
    const std::string errors = (captured / "errors").string();
    std::vector<char*> arguments;
    for (const std::string& each : start.arguments)
        arguments.push_back(const_cast<char*>(each.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        for (const auto& [name, value] : start.environment)
            ::setenv(name.c_str(), value.c_str(), 1);
        const int input = ::open("/dev/null", O_RDONLY);
        const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const int err = ::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (::dup2(input, 0) == 0 && ::dup2(out, 1) == 1 && ::dup2(err, 2) == 2 &&
            ::chdir(start.folder.c_str()) == 0)
            ::execvp(arguments[0], arguments.data());
        ::_exit(127);
    }
    int state = 0;
    ::waitpid(child, &state, 0);
    Ended ended;
    ended.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    if (start.output_file.empty()) ended.output = content_of(output);
    ended.errors = content_of(errors);
    return ended;
}

/// Runs our own program on this source tree, in a folder of the caller's choice.
inline Ended specula_in(const std::filesystem::path& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), SPECULA_BINARY);
    return run_program({.arguments = std::move(arguments),
                        .folder = folder,
                        .environment = {{"SPECULA_HOME", SPECULA_SOURCE_DIR}}});
}

}  // namespace specula
