#include "tests/check.hpp"
#include "tests/tools/validate/made_up_case.hpp"
#include "tools/validate/case_file.hpp"
#include "tools/validate/validation_table.hpp"

namespace specula {
namespace {

const char* const own_folder = SPECULA_SOURCE_DIR "/tests/reference";

TEST_CASE("the project computes and meets every reference case, point by point",
          "[validate][reference]") {
    const Validation validation =
        validate({.folder = own_folder, .threads = 2}, materials_library());
    for (const CaseVerdict& verdict : validation.cases) {
        INFO(verdict.id << ": " << complaint(verdict));
        CHECK(verdict.verdict() == Verdict::pass);
        for (const PointVerdict& point : verdict.points) CHECK_FALSE(point.quantities.empty());
    }
}

TEST_CASE("the reference folder holds the 46 cases of its index", "[validate][reference]") {
    std::size_t n_points = 0;
    const CaseFolder folder = read_case_folder(own_folder);
    for (const CaseFile& file : folder.cases) n_points += file.n_points;
    CHECK(folder.cases.size() == 46);
    CHECK(n_points == 789);
}

}  // namespace
}  // namespace specula
