#include <sstream>

#include "tests/check.hpp"
#include "tools/firmware/latency_figure.hpp"

namespace specula {
namespace {

/// A study whose numbers are as wide as they get.
LatencyStudy wide_study() {
    LatencyStudy study;
    study.experiment = "wide";
    study.worlds = 8;
    study.epochs = 60;
    const Interval interval{.mean = -0.123, .low = -1.0, .high = 1.0};
    for (const int units : {8, 16, 128})
        for (const char* arithmetic : {"float32", "int16", "int8"}) {
            LatencyPoint point;
            point.hidden = {units, units, units};
            point.arithmetic = arithmetic;
            point.n_multiplications = 1234567;
            point.model_bytes = 12345678;
            point.instructions = 123456;
            point.cycles = {100.0 * units, 120.0 * units};
            point.nominal = point.rerecorded = interval;
            point.nominal_loss.value = point.rerecorded_loss.value = interval;
            point.agreement = {{"nominal", -1.0, 1.0, 1.0}, {"tilt_sensor", -1.0, 0.605, 1.0}};
            study.points.push_back(point);
        }
    return study;
}

/// Where two spaces or more part the cells of a line: places of the cells.
std::vector<std::size_t> cell_places(const std::string& line) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool begins = i == 0 || (i > 1 && line[i - 1] == ' ' && line[i - 2] == ' ');
        if (line[i] != ' ' && begins) places.push_back(i);
    }
    return places;
}

TEST_CASE("columns of the latency tables never touch, however wide a number is", "[latency]") {
    std::istringstream lines(latency_text(wide_study()));
    std::vector<std::size_t> head;
    std::size_t n_rows = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("network")) head = cell_places(line);
        if (!line.starts_with("12-")) continue;
        CHECK(cell_places(line) == head);
        ++n_rows;
    }
    CHECK(n_rows == 9 + 6);  // all, then the integers alone
}

TEST_CASE("names of networks stand above all points, neighbours in different rows", "[latency]") {
    const std::string script = latency_figure(wide_study()).script;
    std::istringstream rows(script.substr(script.find("$names << END\n") + 14));
    std::vector<double> heights;
    std::string us, f1, height, name;
    while (rows >> us && us != "END" && rows >> f1 >> height >> name)
        heights.push_back(std::stod(height));
    REQUIRE(heights.size() == 3);
    for (const double each : heights) CHECK(each > 100.0);
    CHECK(heights[0] != heights[1]);
    CHECK(heights[1] != heights[2]);
}

}  // namespace
}  // namespace specula
