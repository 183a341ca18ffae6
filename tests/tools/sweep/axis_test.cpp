#include "tools/sweep/axis.hpp"

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

std::vector<double> values(const std::string& text, const AxisRules& rules = {"deg", -85., 85.}) {
    return read_axis(text, rules, [](const std::string& problem, const std::string& remedy) {
        throw InputError(problem + "; " + remedy);
    });
}

std::string complaint(const std::string& text) {
    return message_of([&] { return values(text); });
}

TEST_CASE("a range holds both its ends, and what is between them by the step", "[sweep]") {
    CHECK(values("0:10:2.5") == std::vector<double>{0.0, 2.5, 5.0, 7.5, 10.0});
    CHECK(values("0:9:2.5") == std::vector<double>{0.0, 2.5, 5.0, 7.5});
    CHECK(values("4") == std::vector<double>{4.0});
    CHECK(values("4:4:1") == std::vector<double>{4.0});
    CHECK(values(" +1.5 , -2 ") == std::vector<double>{-2.0, 1.5});
}

TEST_CASE("a range through zero meets it, whatever the step rounds to", "[sweep]") {
    for (const std::string text : {"-10:10:0.1", "-1:1:0.01", "-0.3:0.3:0.1", "-7:7:0.7"}) {
        const std::vector<double> all = values(text);
        CHECK(std::find(all.begin(), all.end(), 0.0) != all.end());
        CHECK(all.front() == -all.back());
    }
    CHECK(values("0:15:0.1").size() == 151);  // 15 / 0.1 is a hair below 150
}

TEST_CASE("values come in order and each once", "[sweep]") {
    CHECK(values("5,0:10:5,3") == std::vector<double>{0.0, 3.0, 5.0, 10.0});
}

TEST_CASE("an axis that cannot be is refused with a remedy", "[sweep]") {
    CHECK(complaint("10:0:1") == "runs backwards from 10 to 0; put the lower value first");
    CHECK(complaint("0:10:0") == "a step of 0 leads nowhere; use a step above 0");
    CHECK(complaint("0:10:-1").find("the step -1 is negative") == 0);
    CHECK(complaint("0:90:10") == "90 deg is out of range; use values from -85 up to 85 deg");
    CHECK(complaint("0:1:1e-6").find("makes 1e+06 values; use a larger step") == 0);
    for (const std::string text :
         {"", "x", "1:2", "1:2:3:4", "nan", "inf", "1:inf:1", "1,,2", "0x10"})
        CHECK(complaint(text).find("write one value, first:last:step, or several") !=
              std::string::npos);
}

}  // namespace
}  // namespace specula
