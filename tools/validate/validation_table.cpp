#include "tools/validate/validation_table.hpp"

#include <algorithm>
#include <array>

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t n_columns = 7;
using Row = std::array<std::string, n_columns>;

Row row_of(const CaseVerdict& verdict) {
    const Quantity* worst = verdict.worst();
    const auto error = [&](double value) {
        return worst == nullptr ? std::string("-") : ErrorText{value, worst->unit}.text();
    };
    return {verdict.id,
            format("{}", verdict.points.size()),
            error(worst == nullptr ? 0.0 : worst->error),
            error(worst == nullptr ? 0.0 : worst->tolerance),
            worst == nullptr ? "-" : worst->name,
            verdict_name(verdict.verdict()),
            verdict.title};
}

/// Names come from files: no control character reaches the terminal.
std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = '?';
    return text;
}

std::string counted(std::size_t n, const std::string& thing) {
    return format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

/// The second column flush right, the others left, the last as long as it is.
std::string lines(const std::vector<Row>& rows) {
    std::array<std::size_t, n_columns> width{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i + 1 < n_columns; ++i)
            width[i] = std::max(width[i], row[i].size());
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i + 1 < n_columns; ++i) {
            const std::string space(width[i] - row[i].size(), ' ');
            text += (i == 1 ? space + row[i] : row[i] + space) + "  ";
        }
        text += row.back() + "\n";
    }
    return text;
}

std::size_t first_with(const CaseVerdict& verdict, Verdict wanted) {
    const auto found =
        std::find_if(verdict.points.begin(), verdict.points.end(),
                     [&](const PointVerdict& point) { return point.verdict() == wanted; });
    return static_cast<std::size_t>(found - verdict.points.begin());
}

std::string value_text(const QuantityValue& value) {
    struct Writer {
        std::string operator()(std::monostate) const { return "nothing"; }
        std::string operator()(bool flag) const { return flag ? "true" : "false"; }
        std::string operator()(double number) const { return format("{:.8g}", number); }
        std::string operator()(const Complex& z) const {
            return format("{:.8g} {} {:.8g}j", z.real(), z.imag() < 0.0 ? "-" : "+",
                          std::abs(z.imag()));
        }
        std::string operator()(const std::string& text) const { return text; }
    };
    return std::visit(Writer{}, value);
}

}  // namespace

std::string ErrorText::text() const {
    return format("{:.2g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string complaint(const CaseVerdict& verdict) {
    switch (verdict.verdict()) {
        case Verdict::pass:
            break;
        case Verdict::not_computable: {
            const std::size_t point = first_with(verdict, Verdict::not_computable);
            return format("points[{}]: {} ({} of {} points)", point, verdict.points[point].problem,
                          verdict.n_points_with(Verdict::not_computable), verdict.points.size());
        }
        case Verdict::fail: {
            const std::size_t point = verdict.worst_point();
            const Quantity& worst = *verdict.worst();
            return format("points[{}] {} = {}, not {}: off by {}, {} allowed ({} of {} points)",
                          point, worst.name, value_text(worst.computed), value_text(worst.expected),
                          ErrorText{worst.error, worst.unit}.text(),
                          ErrorText{worst.tolerance, worst.unit}.text(),
                          verdict.n_points_with(Verdict::fail), verdict.points.size());
        }
    }
    return {};
}

std::string validation_sum(const Validation& validation) {
    return format("{}, {}: {} pass, {} fail, {} cannot be computed",
                  counted(validation.cases.size(), "case"), counted(validation.n_points(), "point"),
                  validation.n_cases_with(Verdict::pass), validation.n_cases_with(Verdict::fail),
                  validation.n_cases_with(Verdict::not_computable));
}

std::string validation_table(const Validation& validation) {
    std::vector<Row> rows{{"case", "points", "worst error", "tolerance", "of", "verdict", "title"}};
    for (const CaseVerdict& verdict : validation.cases) rows.push_back(row_of(verdict));
    for (Row& row : rows)
        for (std::string& cell : row) cell = printable(cell);
    std::string text = lines(rows);
    const auto add = [&](const std::string& name, const std::string& remark) {
        text += printable(format("{}: {}", name, remark)) + "\n";
    };
    text += "\n";
    for (const CaseVerdict& verdict : validation.cases)
        if (const std::string problem = complaint(verdict); !problem.empty())
            add(verdict.id, problem);
    for (const CaseVerdict& verdict : validation.cases)
        if (const std::size_t n = verdict.n_shown_only(); n > 0)
            add(verdict.id, counted(n, "number") + " informative, not judged");
    for (const std::string& file : validation.others)
        add(file, "no case (neither id nor points), left out");
    return text + validation_sum(validation) + "\n";
}

}  // namespace specula
