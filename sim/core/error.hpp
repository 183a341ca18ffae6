#pragma once

#include <stdexcept>
#include <string>

namespace specula {

/// A mistake of the user's, in one line that says where, what is wrong, and what would do:
/// `file:line: key = value: problem; remedy`.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Something outside the program failed: a disk is full, a folder is read-only, a tool is missing.
/// The message names the path and the system's reason.
class SystemError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace specula
