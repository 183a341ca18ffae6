#pragma once

#include <string>

#include "sim/core/document.hpp"

namespace specula {

/// The top of a document "x.toml" with this content.
inline Section section_of(const std::string& text) {
    return Section::parse(text, "x.toml");
}

}  // namespace specula
