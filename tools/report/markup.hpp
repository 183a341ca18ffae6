#pragma once

#include <string>
#include <string_view>

namespace specula {

/// `text` as it may stand in HTML or SVG, between tags or inside quotes: & < > " ' are written as
/// entities. Control characters other than tab and newline, which both formats forbid, become
/// U+FFFD.
std::string escaped(std::string_view text);

/// `bytes` as a data: address may contain them: all but letters, digits and -_.~ as %XX.
std::string percent_encoded(std::string_view bytes);

}  // namespace specula
