#include "scenes/antenna_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

#include "scenes/antenna.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double rad_per_deg = pi / 180.0;
constexpr std::string_view header = "azimuth_deg,elevation_deg,gain_dbi";
constexpr std::size_t most_rows = 361 * 181;  ///< one degree over the whole sphere
constexpr double weakest_dbi = -200.0, strongest_dbi = 60.0;

/// A line of the file, for messages.
struct Line {
    const std::filesystem::path& file;
    int number;
    std::string text;

    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
        throw InputError(format("{}:{}: {}; {}", file.string(), number, problem, remedy));
    }
};

struct Row {
    double azimuth_deg, elevation_deg, gain_dbi;
};

double number_of(const Line& line, std::string_view word) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!word.empty() && is_blank(word.front())) word.remove_prefix(1);
    while (!word.empty() && is_blank(word.back())) word.remove_suffix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
        line.fail(format("\"{}\" is not a number", word), format("write {}", header));
    return value;
}

Row row_of(const Line& line) {
    std::vector<double> values;
    std::string_view rest = line.text;
    for (bool more = true; more;) {
        const std::size_t comma = rest.find(',');
        more = comma != std::string_view::npos;
        values.push_back(number_of(line, rest.substr(0, comma)));
        if (more) rest.remove_prefix(comma + 1);
    }
    if (values.size() != 3)
        line.fail(format("{} values", values.size()), format("write {}", header));
    if (std::abs(values[0]) > 180.0 || std::abs(values[1]) > 90.0)
        line.fail("is no direction", "azimuth is within 180 degrees, elevation within 90");
    if (values[2] < weakest_dbi || values[2] > strongest_dbi)
        line.fail(format("a gain of {} dBi", values[2]),
                  format("use {} to {} dBi", weakest_dbi, strongest_dbi));
    return {values[0], values[1], values[2]};
}

/// Gains by elevation, then azimuth, in degrees.
using Grid = std::map<double, std::map<double, double>>;

Grid grid_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw InputError(file.string() + ": cannot be read; name a CSV file that exists");
    Grid grid;
    Line line{file, 0, {}};
    std::size_t n_rows = 0;
    while (std::getline(in, line.text)) {
        ++line.number;
        if (!line.text.empty() && line.text.back() == '\r') line.text.pop_back();
        if (line.text.empty() || line.text[0] == '#' || line.text == header) continue;
        if (++n_rows > most_rows)
            line.fail(format("more than {} rows", most_rows), "use steps of a degree or more");
        const Row row = row_of(line);
        if (!grid[row.elevation_deg].emplace(row.azimuth_deg, row.gain_dbi).second)
            line.fail("the direction stands there twice", "keep one of the two rows");
    }
    return grid;
}

/// Place of a value on ascending lines: `value` = (1 - share) lines[i] + share lines[i + 1].
struct Place {
    std::size_t i;
    double share;
};
bool holds(const std::vector<double>& lines, double value) {
    constexpr double rounding_rad = 1e-9;
    return value >= lines.front() - rounding_rad && value <= lines.back() + rounding_rad;
}
Place place_of(const std::vector<double>& lines, double value) {
    const auto above = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
    const auto i = static_cast<std::size_t>(above - lines.begin()) - 1;
    const double share = (value - lines[i]) / (lines[i + 1] - lines[i]);
    return {i, std::clamp(share, 0.0, 1.0)};
}

}  // namespace

TablePattern read_antenna_table(const std::filesystem::path& file) {
    const Grid grid = grid_of(file);
    const auto fail = [&](const std::string& problem, const std::string& remedy) {
        throw InputError(format("{}: {}; {}", file.string(), problem, remedy));
    };
    if (grid.size() < 2 || grid.begin()->second.size() < 2)
        fail("no grid of at least two azimuths and two elevations", format("write {}", header));
    TablePattern table{{}, {}, {}};
    for (const auto& [azimuth_deg, gain_dbi] : grid.begin()->second)
        table.azimuths_rad.push_back(azimuth_deg * rad_per_deg);
    for (const auto& [elevation_deg, row] : grid) {
        table.elevations_rad.push_back(elevation_deg * rad_per_deg);
        const auto same_azimuth = [](const auto& a, const auto& b) { return a.first == b.first; };
        if (!std::equal(row.begin(), row.end(), grid.begin()->second.begin(),
                        grid.begin()->second.end(), same_azimuth))
            fail(format("elevation {} deg has other azimuths than elevation {} deg", elevation_deg,
                        grid.begin()->first),
                 "give every elevation the same azimuths");
        for (const auto& [azimuth_deg, gain_dbi] : row) table.gains_dbi.push_back(gain_dbi);
    }
    if (!holds(table.azimuths_rad, 0.0) || !holds(table.elevations_rad, 0.0))
        fail("does not hold the boresight", "give azimuths and elevations on both sides of 0");
    return table;
}

double TablePattern::gain(const Vector3& direction) const {
    const double azimuth_rad = std::atan2(direction.x(), -direction.z());
    const double elevation_rad = std::asin(std::clamp(direction.y(), -1.0, 1.0));
    if (!holds(azimuths_rad, azimuth_rad) || !holds(elevations_rad, elevation_rad)) return 0.0;
    const Place a = place_of(azimuths_rad, azimuth_rad);
    const Place e = place_of(elevations_rad, elevation_rad);
    const auto along_azimuth = [&](std::size_t row) {
        const double* gains = &gains_dbi[row * azimuths_rad.size() + a.i];
        return (1.0 - a.share) * gains[0] + a.share * gains[1];
    };
    const double dbi = (1.0 - e.share) * along_azimuth(e.i) + e.share * along_azimuth(e.i + 1);
    return std::pow(10.0, 0.1 * dbi);
}

TablePattern TablePattern::read(Section& section) {
    const std::filesystem::path name = section.text("file");
    const TablePattern table = read_antenna_table(
        name.is_absolute() ? name : std::filesystem::path(section.file()).parent_path() / name);
    if (const double share = radiated_share(table); share > largest_radiated_share)
        section.fail(
            "file", format("radiates {:.3g} times the power it is fed", share),
            format("are its gains in dBi? they are {:.3g} dB too high for a passive antenna",
                   10.0 * std::log10(share)));
    return table;
}

}  // namespace specula
