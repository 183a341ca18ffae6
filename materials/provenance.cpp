#include "materials/provenance.hpp"

#include "sim/core/format.hpp"

namespace specula {

namespace {

const std::vector<std::string> evidence_names{"recommendation", "literature", "estimate"};

NumberOrigin read_number(Section section, const FrequencyBand& of_file, const Section& file) {
    NumberOrigin number{.key = section.text("key"),
                        .source = section.text("source"),
                        .evidence = read_evidence(section),
                        .valid = of_file};
    if (!file.has(number.key))
        section.fail("key", "is not a key of this file", "name the number that you mean");
    if (section.has_quantity("valid", Unit::frequency)) number.valid = FrequencyBand::read(section);
    section.finish();
    return number;
}

}  // namespace

std::string_view evidence_name(Evidence evidence) {
    return evidence_names[static_cast<std::size_t>(evidence)];
}

std::string FrequencyBand::text() const {
    return format("{:.6g} to {:.6g} GHz", min_hz * 1e-9, max_hz * 1e-9);
}

FrequencyBand FrequencyBand::read(Section& section) {
    const auto band_hz = section.quantities("valid", Unit::frequency, 2, Range::above(0.0));
    if (!(band_hz[0] < band_hz[1]))
        section.fail_quantity("valid", Unit::frequency, "runs backwards",
                              "put the lower frequency first");
    return {band_hz[0], band_hz[1]};
}

Evidence read_evidence(Section& section) {
    const std::string name = section.choice("evidence", evidence_names, evidence_names.back());
    for (std::size_t i = 0; i < evidence_names.size(); ++i)
        if (evidence_names[i] == name) return static_cast<Evidence>(i);
    return Evidence::estimate;
}

std::vector<NumberOrigin> read_number_origins(Section& file, const FrequencyBand& of_file) {
    std::vector<NumberOrigin> numbers;
    for (Section& section : file.sections("number"))
        numbers.push_back(read_number(section, of_file, file));
    return numbers;
}

}  // namespace specula
