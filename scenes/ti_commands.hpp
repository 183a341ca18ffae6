#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace specula {

/// One command of a TI .cfg file: a name and its arguments by position.
struct TiCommand {
    std::string file;
    int line = 0;
    std::string name;
    std::vector<std::string> arguments;

    /// Argument `i`, called `what` in messages; `fallback` where the line ends before it.
    double number_or(std::size_t i, const std::string& what, double fallback) const;
    int whole_or(std::size_t i, const std::string& what, int fallback) const;
    /// Throws InputError `file:line: command what = value: problem; remedy`.
    [[noreturn]] void fail(std::size_t i, const std::string& what, const std::string& problem,
                           const std::string& remedy) const;
};

/// The commands of one file, as the mmWave L-SDK demos of the xWRL6432 take them.
///
/// `%` begins a comment. Of a command given twice the last counts. Arguments of known commands must
/// be numbers. Throws InputError for what is no command file at all.
struct TiCommandFile {
    std::string file;
    std::vector<TiCommand> commands;
    std::vector<std::string> warnings;  ///< unknown commands, unusual numbers of arguments

    static TiCommandFile read(const std::filesystem::path& file);
    static TiCommandFile parse(const std::string& text, const std::string& name);

    /// The last of that name, null where there is none.
    const TiCommand* find(const std::string& name) const;
    /// Throws InputError where there is none.
    const TiCommand& need(const std::string& name) const;
};

}  // namespace specula
