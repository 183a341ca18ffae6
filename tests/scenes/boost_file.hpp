#pragma once

#include "scenes/radar.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {

inline const std::string boost_text = project_file("scenes/radars/iwrl6432boost.toml");

/// What is said of that radar once its one `from` has become `to`, without file and line.
inline std::string error_with(const std::string& from, const std::string& to) {
    const MadeUpFolder folder;
    const auto file = folder.with("x.toml", edited(boost_text, from, to));
    const std::string message = message_of([&] { return read_radar(file); });
    const auto at = message.find(": ");
    return at == std::string::npos ? message : message.substr(at + 2);
}

}  // namespace specula
