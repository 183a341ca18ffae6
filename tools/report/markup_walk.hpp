#pragma once

#include <string_view>

namespace specula {

/// Calls `on_tag("<...>")` and `on_text("...")` in the order of the document. In the SVG of gnuplot
/// and in ours, '<' begins a tag wherever it stands and no attribute contains '>'.
template <class OnTag, class OnText>
void walk_markup(std::string_view markup, OnTag&& on_tag, OnText&& on_text) {
    while (!markup.empty()) {
        const std::size_t end = markup.front() == '<' ? markup.find('>') : markup.find('<');
        const bool is_tag = markup.front() == '<' && end != std::string_view::npos;
        const std::string_view piece = markup.substr(0, is_tag ? end + 1 : end);
        if (is_tag)
            on_tag(piece);
        else
            on_text(piece);
        markup.remove_prefix(piece.size());
    }
}

/// The value of attribute `name` of a tag, or an empty view. Either kind of quote will do.
inline std::string_view attribute(std::string_view tag, std::string_view name) {
    for (std::size_t at = tag.find(name); at != std::string_view::npos;
         at = tag.find(name, at + 1)) {
        const std::size_t quote = at + name.size() + 1;
        const bool whole_word = at > 0 && (tag[at - 1] == ' ' || tag[at - 1] == '\n');
        if (!whole_word || quote >= tag.size() || tag[quote - 1] != '=') continue;
        const std::size_t end = tag.find(tag[quote], quote + 1);
        if (end != std::string_view::npos) return tag.substr(quote + 1, end - quote - 1);
    }
    return {};
}

/// Replaces every `from` in `text`.
inline std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
    std::string out;
    for (std::size_t at = text.find(from); at != std::string_view::npos; at = text.find(from)) {
        out.append(text.substr(0, at)).append(to);
        text.remove_prefix(at + from.size());
    }
    return out.append(text);
}

}  // namespace specula
