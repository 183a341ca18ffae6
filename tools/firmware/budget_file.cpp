#include "tools/firmware/budget_file.hpp"

#include "sim/core/document.hpp"

namespace specula {

namespace {

constexpr double most_instructions = 1e9;
constexpr double most_bytes = 524288;  // the chip's RAM

void compare(Excess cost, std::vector<Excess>& found) {
    if (cost.spent > cost.allowed) found.push_back(cost);
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

std::vector<Excess> find_excess(const Verification& verification,
                                const std::filesystem::path& budget_file, bool default_shape) {
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
    for (const char* arithmetic : {"float32", "int16", "int8"}) {
        Section section = root.section(arithmetic);
        if (default_shape)
            compare_stages(section, verification.stages.at(arithmetic), arithmetic, found);
    }
    return found;
}

}  // namespace specula
