#include <charconv>

#include "sim/core/format.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/markup_walk.hpp"
#include "tools/report/palette.hpp"
#include "tools/report/svg.hpp"

namespace specula {
namespace {

/// Reads "rgb( 38,  75, 150)", gnuplot's spacing included, into "#264b96".
std::string hex_of(std::string_view rgb) {
    std::uint8_t channel[3] = {};
    for (auto& value : channel) {
        rgb.remove_prefix(std::min(rgb.find_first_of("0123456789"), rgb.size()));
        const auto [end, error] = std::from_chars(rgb.data(), rgb.data() + rgb.size(), value);
        if (error != std::errc{}) return {};
        rgb.remove_prefix(static_cast<std::size_t>(end - rgb.data()));
    }
    return Rgb{channel[0], channel[1], channel[2]}.hex();
}

/// What the page calls this colour; the colour itself if it has no role.
std::string page_colour(std::string_view rgb) {
    const std::string hex = hex_of(rgb);
    if (hex == ink) return "currentColor";
    for (const ColourRole& role : colour_roles)
        if (hex == role.light) return format("var({})", role.variable);
    return std::string(rgb);
}

std::string with_page_colours(std::string_view tag) {
    std::string out;
    for (std::size_t at = tag.find("rgb("); at != std::string_view::npos; at = tag.find("rgb(")) {
        const std::size_t end = tag.find(')', at) + 1;
        out.append(tag.substr(0, at)).append(page_colour(tag.substr(at, end - at)));
        tag.remove_prefix(end);
    }
    out.append(tag);
    return replaced(replaced(out, "\"black\"", "\"currentColor\""), "'black'", "'currentColor'");
}

std::string with_prefixed_ids(const std::string& tag, const std::string& prefix) {
    std::string out = tag;
    for (const std::string_view mark : {" id='", " id=\"", "href='#", "href=\"#", "url(#"})
        out = replaced(out, mark, format("{}{}-", mark, prefix));
    return out;
}

std::string page_root(std::string_view tag, const std::string& prefix) {
    return format(
        "<svg class=\"plot\" viewBox=\"{0}\" width=\"{1}\" height=\"{2}\" role=\"img\" "
        "aria-labelledby=\"{3}-title {3}-desc\" xmlns=\"http://www.w3.org/2000/svg\" "
        "xmlns:xlink=\"http://www.w3.org/1999/xlink\">",
        attribute(tag, "viewBox"), attribute(tag, "width"), attribute(tag, "height"), prefix);
}

bool is_ground(std::string_view tag) {
    return tag.starts_with("<rect x=\"0\" y=\"0\"") && attribute(tag, "fill") == "#ffffff";
}

std::string page_tag(std::string_view tag, const std::string& prefix) {
    if (tag.starts_with("<?") || is_ground(tag)) return {};
    if (tag.starts_with("<svg")) return page_root(tag, prefix);
    if (tag == "<title>") return format("<title id=\"{}-title\">", prefix);
    if (tag == "<desc>") return format("<desc id=\"{}-desc\">", prefix);
    return with_prefixed_ids(with_page_colours(tag), prefix);
}

}  // namespace

std::string inline_svg(std::string_view svg, const std::string& prefix) {
    std::string out;
    walk_markup(
        svg, [&](std::string_view tag) { out += page_tag(tag, prefix); },
        [&](std::string_view text) { out += text; });
    out.erase(0, out.find('<'));
    return out;
}

}  // namespace specula
