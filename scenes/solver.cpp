#include "scenes/solver.hpp"

namespace specula {

Solver read_solver(Section& root) {
    Solver solver;
    auto section = root.find_section("solver");
    if (!section) return solver;
    solver.accuracy_db =
        section->number("accuracy_db", Range::between(1e-6, 3.0), solver.accuracy_db);
    solver.max_bounces = section->count("max_bounces", Range::between(1, 4), solver.max_bounces);
    const std::string roughness =
        section->choice("roughness", {"statistical", "height_field", "coherent"}, "statistical");
    if (roughness == "height_field") solver.roughness = Solver::Roughness::height_field;
    if (roughness == "coherent") solver.roughness = Solver::Roughness::coherent;
    solver.edge_currents = section->flag("edge_currents", solver.edge_currents);
    section->finish();
    return solver;
}

}  // namespace specula
