#pragma once

#include <string>
#include <vector>

#include "materials/library.hpp"
#include "tools/validate/case_file.hpp"
#include "tools/validate/quantity.hpp"

namespace specula {

/// One point of a case, as a compute function gets it.
struct CasePoint {
    const CaseFile& file;
    Fields inp;
    Fields expect;
    Fields tolerance;
    const Library& materials;

    CasePoint(const CaseFile& case_file, std::size_t index, const Library& known_materials)
        : file(case_file),
          inp(case_file.inp(index)),
          expect(case_file.expect(index)),
          tolerance(case_file.tolerance()),
          materials(known_materials) {}

    /// Whether a sentence of the tolerance's note calls rows informative and holds, as a word, a
    /// text of this point's `inp`: the point is then shown and not judged.
    bool is_informative() const;
};

/// Computes from `inp` whatever `expect` holds. Throws NotComputable where it cannot, InputError
/// where the file is wrong.
using ComputePoint = std::vector<Quantity> (*)(const CasePoint& point);

/// The way to compute a kind of case ("M03"); null where there is none. To add a kind: write its
/// function in cases/, name it in cases/cases.hpp and in the table of case_kind.cpp.
ComputePoint find_case_kind(const std::string& kind);

/// "M" -> "Materials": what the kinds that begin with a letter are about.
std::string case_group_title(const std::string& kind);

}  // namespace specula
