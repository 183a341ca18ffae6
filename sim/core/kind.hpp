#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "sim/core/document.hpp"

namespace specula {

/// The names of a family's members, in the order of its variant.
template <typename Family>
std::vector<std::string> kinds_of() {
    return []<typename... Members>(std::type_identity<std::variant<Members...>>) {
        return std::vector<std::string>{std::string(Members::kind)...};
    }(std::type_identity<Family>{});
}

/// Reads the member of a family that `section.<key>` names; each member reads its own keys.
template <typename Family>
Family read_kind(Section& section, const std::string& key) {
    const std::string wanted = section.choice(key, kinds_of<Family>());
    return [&]<typename... Members>(std::type_identity<std::variant<Members...>>) {
        Family result;
        (void)((Members::kind == wanted && (result = Members::read(section), true)) || ...);
        return result;
    }(std::type_identity<Family>{});
}

}  // namespace specula
