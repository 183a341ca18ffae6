#include "tools/firmware/budget_file.hpp"

#include "classifier/descriptor.hpp"
#include "sim/core/document.hpp"

namespace specula {

namespace {

constexpr double most_instructions = 1e9;
constexpr double most_bytes = 524288;  // the chip's RAM

void compare(Excess cost, std::vector<Excess>& found) {
    if (cost.spent > cost.allowed) found.push_back(cost);
}

bool has_layers(const Model& model, const std::vector<std::size_t>& widths) {
    std::vector<std::size_t> own{model.n_features()};
    for (const HiddenLayer& layer : model.hidden) own.push_back(layer.n_out);
    own.push_back(model.n_classes());
    return own == widths;
}

void compare_stages(Section section, const std::map<std::string, StageCost>& stages,
                    const std::string& arithmetic, std::vector<Excess>& found) {
    for (const auto& [stage, cost] : stages)
        if (section.has(stage))
            compare({.what = stage + " in " + arithmetic,
                     .spent = cost.instructions,
                     .allowed = section.number(stage, Range::between(0, most_instructions)),
                     .unit = "instructions"},
                    found);
    section.finish();
}

}  // namespace

BudgetShape budget_shape_of(const VerifyInput& input) {
    const bool same_frame =
        input.frames.n_samples == 128 && input.frames.n_rx == 3 && input.frames.n_chirps == 1;
    if (!same_frame) return BudgetShape::none;
    if (descriptor_of(input.model).extractor == "peak_shape")
        return has_layers(input.model, {25, 32, 32, 5}) ? BudgetShape::peak_shape
                                                        : BudgetShape::none;
    return has_layers(input.model, {FW_DEFAULT_N_BINS, 16, 16, 5}) ? BudgetShape::range_bins
                                                                   : BudgetShape::none;
}

std::vector<Excess> find_excess(const Verification& verification,
                                const std::filesystem::path& budget_file, BudgetShape shape) {
    Section root = Section::read(budget_file);
    std::vector<Excess> found;
    ModuleSize sum;
    for (const auto& [name, size] : verification.modules) {
        sum.code += size.code;
        sum.constants += size.constants;
        sum.ram += size.ram;
    }
    Section bytes = root.section("bytes");
    const auto compare_bytes = [&](const char* key, std::size_t spent) {
        compare({.what = key,
                 .spent = static_cast<double>(spent),
                 .allowed = bytes.number(key, Range::between(0, most_bytes)),
                 .unit = "bytes"},
                found);
    };
    compare_bytes("code", sum.code);
    compare_bytes("constants", sum.constants);
    compare_bytes("ram", sum.ram);
    compare_bytes("stack", verification.stacks.front().bytes);
    bytes.finish();
    Section peak_shape = root.section("peak_shape");
    for (const char* arithmetic : {"float32", "int16", "int8"}) {
        const Section bins = root.section(arithmetic), around = peak_shape.section(arithmetic);
        if (shape != BudgetShape::none)
            compare_stages(shape == BudgetShape::peak_shape ? around : bins,
                           verification.stages.at(arithmetic), arithmetic, found);
    }
    return found;
}

}  // namespace specula
