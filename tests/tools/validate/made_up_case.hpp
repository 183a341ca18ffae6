#pragma once

#include <nlohmann/json.hpp>

#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/reference_case.hpp"
#include "tools/validate/validate.hpp"

namespace specula {

/// A case of one point.
inline nlohmann::json case_of(const std::string& id, const nlohmann::json& inp,
                              const nlohmann::json& expect, const nlohmann::json& tolerance) {
    return {{"id", id},
            {"title", "made up"},
            {"tolerance", tolerance},
            {"points", {{{"inp", inp}, {"expect", expect}}}}};
}

inline const Library& materials_library() {
    static const Library library(SPECULA_SOURCE_DIR "/materials/library");
    return library;
}

/// What the program makes of a text as a case file.
inline Validation validated_text(const std::string& text) {
    const MadeUpFolder folder;
    return validate({.folder = folder.with("case.json", text).parent_path(), .threads = 1},
                    materials_library());
}

inline CaseVerdict validated(const nlohmann::json& document) {
    return validated_text(document.dump()).cases.front();
}

inline void check_passes(const nlohmann::json& document) {
    const CaseVerdict verdict = validated(document);
    INFO(verdict.id << " " << verdict.points.front().problem);
    for (const Quantity& quantity : verdict.points.front().quantities) {
        INFO(quantity.name << " off by " << quantity.error << ", allowed " << quantity.tolerance);
        CHECK(quantity.passes());
    }
    CHECK(verdict.verdict() == Verdict::pass);
}

/// Of the first point, what was computed for a name.
inline QuantityValue computed(const CaseVerdict& verdict, const std::string& name) {
    for (const Quantity& quantity : verdict.points.front().quantities)
        if (quantity.name == name) return quantity.computed;
    throw std::runtime_error(name + " was not computed: " + verdict.points.front().problem);
}

inline nlohmann::json pair_of(std::complex<double> z) {
    return {z.real(), z.imag()};
}

}  // namespace specula
