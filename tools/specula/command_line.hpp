#pragma once

namespace specula {

/// Parses the arguments, runs the sub-command, and turns every error into one line on standard
/// error. Exit status: 0 done, 1 something outside failed, 2 wrong input.
int run_program(int argc, char** argv);

}  // namespace specula
