#pragma once

#include <string>

namespace specula {

/// Lines on standard error, coloured on a terminal.
void say_warning(const std::string& text);
void say_error(const std::string& text);

}  // namespace specula
