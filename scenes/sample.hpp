#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "materials/stack.hpp"
#include "materials/validity.hpp"
#include "scenes/mesh.hpp"
#include "scenes/plate.hpp"

namespace specula {

/// One of several layers of a sample.
struct SampleLayer {
    std::string material;
    double thickness_m = 0.005;  ///< > 0
    double roughness_m = 0.0;    ///< rms height of its upper face, >= 0
    bool turned = false;         ///< its grain runs across that of the sample, as in plywood
    double correlation_m = usual_correlation_m;  ///< of its upper face's heights, > 0

    /// Machined and honed faces lie between 0.2 and 5 mm.
    static constexpr double usual_correlation_m = 1e-3;
};

/// A piece of material: the one under the radar, or another object.
struct Sample {
    std::string material;  ///< of a layered one, that of its uppermost layer
    Plate face;
    double thickness_m = 0.005;        ///< > 0; of a layered one, of all layers together
    double roughness_m = 0.0;          ///< rms height of the face, >= 0
    double permittivity_factor = 1.0;  ///< this piece over the library's material, real part
    double loss_factor = 1.0;          ///< the same for the loss tangent
    std::string backing = "air";       ///< "air", "metal" (perfect), or a material in contact
    std::vector<SampleLayer>
        layers{};            ///< the one facing the radar first; empty: all is `material`
    double grain_rad = 0.0;  ///< from the sample's y axis to the grain, about its normal
    double correlation_m = SampleLayer::usual_correlation_m;  ///< of the face's heights, > 0
    std::uint64_t piece = 1;  ///< which physical piece: seed of its heights, not of its place

    /// In the sample's own frame; where there is one, it takes the place of `face`, of which only
    /// the size is then meant.
    std::shared_ptr<const Mesh> mesh{};
    std::optional<bool> opaque{};  ///< as the file says; else by what it is made of

    /// Its layers, be there one or several.
    std::vector<SampleLayer> all_layers() const;
    /// "limestone", or "rust on iron".
    std::string title() const;
    /// Its faces as triangles in the scene.
    Mesh triangles(const Placement& placement) const;
};

/// What the roughness of a sample's faces breaks of the theory that its diffuse echo rests on.
std::vector<std::string> roughness_warnings(const Sample& sample, const FrequencyBand& used);

/// The warnings of all materials in a sample, its backing included.
std::vector<BandWarning> band_warnings(const Sample& sample, const Library& library,
                                       const FrequencyBand& used);

}  // namespace specula
