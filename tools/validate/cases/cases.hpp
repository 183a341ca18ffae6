#pragma once

#include "tools/validate/case_kind.hpp"

namespace specula {

/// The kinds of cases, one function each; the table in case_kind.cpp says which is which.

// Materials
std::vector<Quantity> fresnel_point(const CasePoint& point);
std::vector<Quantity> building_material_point(const CasePoint& point);
std::vector<Quantity> slab_point(const CasePoint& point);
std::vector<Quantity> stack_point(const CasePoint& point);
std::vector<Quantity> metal_point(const CasePoint& point);
std::vector<Quantity> mixing_point(const CasePoint& point);
std::vector<Quantity> relaxation_point(const CasePoint& point);
std::vector<Quantity> roughness_point(const CasePoint& point);
std::vector<Quantity> energy_point(const CasePoint& point);
std::vector<Quantity> slab_echo_point(const CasePoint& point);

// Statistics
std::vector<Quantity> rough_plate_point(const CasePoint& point);

// FMCW radar
std::vector<Quantity> range_bin_point(const CasePoint& point);
std::vector<Quantity> displacement_point(const CasePoint& point);
std::vector<Quantity> two_targets_point(const CasePoint& point);
std::vector<Quantity> doppler_point(const CasePoint& point);
std::vector<Quantity> noise_budget_point(const CasePoint& point);
std::vector<Quantity> quantisation_point(const CasePoint& point);
std::vector<Quantity> phase_noise_point(const CasePoint& point);
std::vector<Quantity> high_pass_point(const CasePoint& point);
std::vector<Quantity> received_power_point(const CasePoint& point);
std::vector<Quantity> leakage_point(const CasePoint& point);

// Invariants
std::vector<Quantity> pattern_integral_point(const CasePoint& point);
std::vector<Quantity> reciprocity_point(const CasePoint& point);
std::vector<Quantity> intercepted_power_point(const CasePoint& point);

// Near field, cross-sections, numerics
std::vector<Quantity> infinite_plane_point(const CasePoint& point);
std::vector<Quantity> conducting_sphere_point(const CasePoint& point);
std::vector<Quantity> dielectric_sphere_point(const CasePoint& point);
std::vector<Quantity> plate_point(const CasePoint& point);
std::vector<Quantity> dielectric_plate_point(const CasePoint& point);
std::vector<Quantity> near_to_far_point(const CasePoint& point);
std::vector<Quantity> bowed_plate_point(const CasePoint& point);
std::vector<Quantity> chirp_response_point(const CasePoint& point);
std::vector<Quantity> disc_echo_point(const CasePoint& point);
std::vector<Quantity> sphere_echo_point(const CasePoint& point);
std::vector<Quantity> corner_images_point(const CasePoint& point);
std::vector<Quantity> plate_cross_section_point(const CasePoint& point);
std::vector<Quantity> triangle_point(const CasePoint& point);
std::vector<Quantity> dihedral_point(const CasePoint& point);
std::vector<Quantity> trihedral_point(const CasePoint& point);
std::vector<Quantity> disc_or_cylinder_point(const CasePoint& point);
std::vector<Quantity> path_sum_point(const CasePoint& point);

// Full wave
std::vector<Quantity> conducting_strip_point(const CasePoint& point);
std::vector<Quantity> dielectric_strip_point(const CasePoint& point);

}  // namespace specula
