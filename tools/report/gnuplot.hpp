#pragma once

#include <string>
#include <string_view>

namespace specula {

/// Runs gnuplot, a separate process without a shell, and returns what it writes to its output.
///
/// Start-up files are ignored and the locale is fixed, so that equal scripts give equal bytes.
/// @in   script   commands; must set a terminal and no output file
/// @in   program  name searched in PATH, or a path
/// @out  the bytes of the picture, never empty
/// Throws SystemError: the program is missing, or gnuplot's own message with the script's line.
std::string run_gnuplot(std::string_view script, const std::string& program = "gnuplot");

/// `text` as a gnuplot string constant. Single quotes: the only form in which gnuplot neither
/// expands backslashes nor runs `commands` in back quotes. Control characters become spaces.
std::string gnuplot_quoted(std::string_view text);

}  // namespace specula
