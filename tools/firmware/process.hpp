#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace specula {

/// A program to run: its words, and the folder it works in.
struct Command {
    std::vector<std::string> words;
    std::filesystem::path folder;
    std::string package;   ///< of Debian, to be named where the program is missing
    std::string remedy{};  ///< what to do then, of a program that no package has
};

/// What a program said, on both of its outputs, and how it ended.
struct Finished {
    int status = 0;  ///< exit status; 128 + the signal's number where one ended it
    std::string output;
};

/// Runs a program without input and waits for it.
/// Throws SystemError where it cannot be started, naming the package to install or the remedy.
Finished run_program_and_wait(const Command& command);

/// The same; throws SystemError with the last line it said unless its status is 0.
std::string output_of(const Command& command);

}  // namespace specula
