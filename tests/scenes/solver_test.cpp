#include "scenes/solver.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

Solver solver_of(const std::string& text) {
    Section root = Section::parse(text, "x.toml");
    const Solver solver = read_solver(root);
    root.finish();
    return solver;
}

TEST_CASE("a file without [solver] asks for a tenth of a dB and three bounces", "[solver]") {
    CHECK(solver_of("").accuracy_db == 0.1);
    CHECK(solver_of("").max_bounces == 3);
}

TEST_CASE("[solver] sets accuracy and bounces, each alone", "[solver]") {
    CHECK(solver_of("[solver]\naccuracy_db = 0.01\n").accuracy_db == 0.01);
    CHECK(solver_of("[solver]\naccuracy_db = 0.01\n").max_bounces == 3);
    CHECK(solver_of("[solver]\nmax_bounces = 1\n").max_bounces == 1);
    CHECK_FALSE(solver_of("").edge_currents);
    CHECK(solver_of("[solver]\nedge_currents = true\n").edge_currents);
}

TEST_CASE("heights are statistics unless the file says otherwise", "[solver]") {
    using Roughness = Solver::Roughness;
    CHECK(solver_of("").roughness == Roughness::statistical);
    CHECK(solver_of("[solver]\nroughness = 'coherent'\n").roughness == Roughness::coherent);
    CHECK(solver_of("[solver]\nroughness = 'height_field'\n").roughness == Roughness::height_field);
    CHECK(message_of([] {
              return solver_of("[solver]\nroughness = 'mesh'\n");
          }).find("\"statistical\", \"height_field\" or \"coherent\"") != std::string::npos);
}

TEST_CASE("a solver that cannot keep its promise is refused", "[solver]") {
    const auto error = [](const std::string& line) {
        return message_of([&] { return solver_of("[solver]\n" + line + "\n"); });
    };
    CHECK(error("accuracy_db = 0") ==
          "x.toml:2: solver.accuracy_db = 0: is out of range; give a value at least 1e-06 and at "
          "most 3");
    CHECK(error("max_bounces = 5").find("solver.max_bounces = 5: is out of range") !=
          std::string::npos);
    CHECK(error("max_bounce = 2").find("did you mean max_bounces?") != std::string::npos);
}

}  // namespace
}  // namespace specula
