#include "sim/core/format.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/markup.hpp"
#include "tools/report/markup_walk.hpp"
#include "tools/report/svg.hpp"

namespace specula {
namespace {

constexpr std::string_view font_families = "Helvetica, Arial, Liberation Sans, sans-serif";

/// gnuplot does not know bold in SVG and writes "Helvetica:Bold" as the name of a family.
std::string with_fonts(std::string_view tag) {
    const std::string family = format("font-family=\"{}\"", font_families);
    std::string out = replaced(tag, format("font-family=\"{}:Bold\"", figure_font),
                               family + " font-weight=\"bold\"");
    return replaced(out, format("font-family=\"{}\"", figure_font), family);
}

class Titling {
  public:
    explicit Titling(const Figure& figure) : figure_(figure) {}

    void tag(std::string_view piece) {
        if (piece == "<title>" || piece == "<desc>") {
            inside_old_title_ = true;
        } else if (piece == "</title>" || piece == "</desc>") {
            inside_old_title_ = false;
        } else if (piece == "</g>" && group_is_empty_) {
            out_.resize(group_begin_);
            group_is_empty_ = false;
        } else {
            append(piece);
        }
    }

    void text(std::string_view piece) {
        if (inside_old_title_) return;
        if (piece.find_first_not_of(" \t\n") != std::string_view::npos) group_is_empty_ = false;
        out_ += piece;
    }

    std::string result() && { return std::move(out_); }

  private:
    void append(std::string_view piece) {
        group_is_empty_ = piece.starts_with("<g ") && attribute(piece, "id").empty();
        group_begin_ = out_.size();
        std::string tag = replaced(with_fonts(piece), " shape-rendering='crispEdges'", "");
        if (attribute(tag, "id").starts_with("gnuplot_plot_"))  // begins again in each multiplot
            tag = format("<g id=\"plot-{}\">", ++n_plots_);
        out_ += tag;
        if (tag.starts_with("<svg"))
            out_ += format("\n<title>{}</title>\n<desc>{}</desc>", escaped(figure_.title),
                           escaped(figure_.description));
    }

    const Figure& figure_;
    std::string out_;
    std::size_t group_begin_ = 0;
    bool group_is_empty_ = false;
    bool inside_old_title_ = false;
    int n_plots_ = 0;
};

}  // namespace

std::string titled_svg(std::string_view drawn, const Figure& figure) {
    Titling titling(figure);
    walk_markup(
        drawn, [&](std::string_view piece) { titling.tag(piece); },
        [&](std::string_view piece) { titling.text(piece); });
    return std::move(titling).result();
}

}  // namespace specula
