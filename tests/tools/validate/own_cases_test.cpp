#include "tests/check.hpp"
#include "tests/tools/validate/made_up_case.hpp"
#include "tools/validate/case_kind.hpp"
#include "tools/validate/validation_table.hpp"

namespace specula {
namespace {

const Validation& own_validation() {
    static const Validation validation = validate(
        {.folder = SPECULA_SOURCE_DIR "/tests/reference", .threads = 1}, materials_library());
    return validation;
}

TEST_CASE("the project meets every reference case that it can compute", "[validate][reference]") {
    for (const CaseVerdict& verdict : own_validation().cases) {
        INFO(verdict.id << ": " << complaint(verdict));
        if (find_case_kind(verdict.kind) != nullptr) CHECK(verdict.verdict() == Verdict::pass);
    }
}

TEST_CASE("every quantity of every point is computed or reported", "[validate][reference]") {
    for (const CaseVerdict& verdict : own_validation().cases)
        for (const PointVerdict& point : verdict.points)
            CHECK((point.quantities.empty() != point.problem.empty()));
}

TEST_CASE("the reference folder holds the 46 cases of its index", "[validate][reference]") {
    CHECK(own_validation().cases.size() == 46);
    CHECK(own_validation().n_points() == 789);
}

}  // namespace
}  // namespace specula
