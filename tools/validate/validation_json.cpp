#include "tools/validate/validation_json.hpp"

#include <nlohmann/json.hpp>

#include "sim/core/version.hpp"

namespace specula {

namespace {

using Ordered = nlohmann::ordered_json;

Ordered value_json(const QuantityValue& value) {
    struct Writer {
        Ordered operator()(std::monostate) const { return nullptr; }
        Ordered operator()(bool flag) const { return flag; }
        Ordered operator()(double number) const { return number; }
        Ordered operator()(const Complex& z) const { return {z.real(), z.imag()}; }
        Ordered operator()(const std::string& text) const { return text; }
    };
    return std::visit(Writer{}, value);
}

const char* word(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            break;
        case Verdict::fail:
            return "fail";
        case Verdict::not_computable:
            return "not_computable";
    }
    return "pass";
}

Ordered quantity_json(const Quantity& quantity) {
    return {{"name", quantity.name},
            {"computed", value_json(quantity.computed)},
            {"expected", value_json(quantity.expected)},
            {"error", quantity.error},
            {"tolerance", quantity.tolerance},
            {"unit", quantity.unit},
            {"judged", quantity.judged},
            {"pass", quantity.passes()}};
}

Ordered case_json(const CaseVerdict& verdict) {
    Ordered json{{"id", verdict.id},
                 {"title", verdict.title},
                 {"level", verdict.level},
                 {"file", verdict.path.string()},
                 {"verdict", word(verdict.verdict())}};
    if (const Quantity* worst = verdict.worst()) {
        json["worst"] = quantity_json(*worst);
        json["worst"]["point"] = verdict.worst_point();
    } else {
        json["worst"] = nullptr;
    }
    json["points"] = Ordered::array();
    for (const PointVerdict& point : verdict.points) {
        Ordered entry{{"verdict", word(point.verdict())}};
        if (!point.problem.empty()) entry["problem"] = point.problem;
        entry["quantities"] = Ordered::array();
        for (const Quantity& quantity : point.quantities)
            entry["quantities"].push_back(quantity_json(quantity));
        json["points"].push_back(std::move(entry));
    }
    return json;
}

}  // namespace

std::string validation_json(const Validation& validation) {
    Ordered json{{"format", "specula-validation"},
                 {"format_version", 1},
                 {"software_version", program_version},
                 {"folder", validation.folder.string()},
                 {"verdict", word(validation.verdict())},
                 {"n_cases", validation.cases.size()},
                 {"n_points", validation.n_points()},
                 {"n_cases_pass", validation.n_cases_with(Verdict::pass)},
                 {"n_cases_fail", validation.n_cases_with(Verdict::fail)},
                 {"n_cases_not_computable", validation.n_cases_with(Verdict::not_computable)},
                 {"not_cases", validation.others},
                 {"cases", Ordered::array()}};
    for (const CaseVerdict& verdict : validation.cases) json["cases"].push_back(case_json(verdict));
    return json.dump(1, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

}  // namespace specula
