#include "tools/validate/case_kind.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "sim/core/format.hpp"
#include "tools/validate/cases/cases.hpp"

namespace specula {

namespace {

const std::map<std::string, ComputePoint> kinds{
    {"M01", fresnel_point},
    {"M02", building_material_point},
    {"M03", slab_point},
    {"M04", stack_point},
    {"M05", metal_point},
    {"M06", mixing_point},
    {"M07", relaxation_point},
    {"M08", roughness_point},
    {"M09", energy_point},
    {"M10", slab_echo_point},
    {"F01", range_bin_point},
    {"F03", displacement_point},
    {"F04", two_targets_point},
    {"F05", doppler_point},
    {"F06", noise_budget_point},
    {"F07", quantisation_point},
    {"F08", phase_noise_point},
    {"F09", high_pass_point},
    {"F10", received_power_point},
    {"F11", leakage_point},
    {"E01", reciprocity_point},
    {"E02", pattern_integral_point},
    {"E04", intercepted_power_point},
    {"N01", infinite_plane_point},
    {"N02", disc_echo_point},
    {"N03", plate_point},
    {"N04", plate_point},
    {"N05", plate_point},
    {"N06", dielectric_plate_point},
    {"N07", corner_images_point},
    {"N08", plate_point},
    {"N09", sphere_echo_point},
    {"N10", near_to_far_point},
    {"N11", chirp_response_point},
    {"N12", bowed_plate_point},
    {"R01", conducting_sphere_point},
    {"R02", dielectric_sphere_point},
    {"S01", rough_plate_point},
    {"R03", plate_cross_section_point},
    {"R04", triangle_point},
    {"R05", dihedral_point},
    {"R06", trihedral_point},
    {"R07", disc_or_cylinder_point},
    {"U01", path_sum_point},
    {"W01", conducting_strip_point},
    {"W02", dielectric_strip_point},
};

/// In lower case, with a space for whatever is no letter or digit; sentences end in `stop`.
std::string words_of(std::string text, char stop) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool ends = c == '.' && (i + 1 == text.size() || text[i + 1] == ' ');
        text[i] = std::isalnum(c) ? static_cast<char>(std::tolower(c)) : ends ? stop : ' ';
    }
    return text;
}

}  // namespace

bool CasePoint::is_informative() const {
    if (!tolerance.is_text("note")) return false;
    const std::string note = words_of(tolerance.text("note"), '.');
    for (std::size_t begin = 0; begin < note.size();) {
        const std::size_t end = std::min(note.find('.', begin), note.size());
        const std::string sentence = " " + note.substr(begin, end - begin) + " ";
        begin = end + 1;
        if (sentence.find(" informative ") == std::string::npos) continue;
        for (const std::string& text : inp.texts()) {
            const std::string words = words_of(text, ' ');
            const bool says_something = words.find_first_not_of(' ') != std::string::npos;
            if (says_something && sentence.find(" " + words + " ") != std::string::npos)
                return true;
        }
    }
    return false;
}

ComputePoint find_case_kind(const std::string& kind) {
    const auto found = kinds.find(kind);
    return found == kinds.end() ? nullptr : found->second;
}

std::string case_group_title(const std::string& kind) {
    static const std::map<char, std::string> titles{
        {'M', "Materials"},  {'R', "Radar cross-sections"},
        {'N', "Near field"}, {'F', "FMCW radar"},
        {'E', "Invariants"}, {'U', "Numerics"},
        {'S', "Statistics"}, {'W', "Full wave"}};
    const auto found = kind.empty() ? titles.end() : titles.find(kind.front());
    return found == titles.end() ? format("Group {}", kind.substr(0, 1)) : found->second;
}

}  // namespace specula
