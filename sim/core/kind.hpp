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

/// A member from its section; with the context if its `read` asks for one.
template <typename Member, typename... Context>
Member read_member(Section& section, const Context&... context) {
    if constexpr (requires { Member::read(section, context...); })
        return Member::read(section, context...);
    else
        return Member::read(section);
}

/// Reads the member of a family that `section.<key>` names; each member reads its own keys.
template <typename Family, typename... Context>
Family read_kind(Section& section, const std::string& key, const Context&... context) {
    const std::string wanted = section.choice(key, kinds_of<Family>());
    return [&]<typename... Members>(std::type_identity<std::variant<Members...>>) {
        Family result;
        (void)((Members::kind == wanted &&
                (result = read_member<Members>(section, context...), true)) ||
               ...);
        return result;
    }(std::type_identity<Family>{});
}

}  // namespace specula
