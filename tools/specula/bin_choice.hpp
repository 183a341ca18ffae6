#pragma once

#include <optional>
#include <string>

#include "classifier/descriptor.hpp"

namespace specula {

/// "6:12" -> bins 6 to 17; empty -> nothing. Throws InputError for anything else.
std::optional<BinChoice> parse_bin_choice(const std::string& text);

}  // namespace specula
