#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "classifier/json_field.hpp"
#include "scenes/catalogue.hpp"

namespace specula {

/// The page's unit of chirp slopes.
inline constexpr double hz_s_per_mhz_us = 1e12;

/// What the page's controls say: a scene, the board's state, and which recording of it.
struct SceneRequest {
    std::string material = "aluminium";
    std::string radar = "iwrl6432boost";
    std::string tilted = "sensor";
    std::string tilt_plane = "azimuth";
    double size_mm = 300.0;
    double thickness_mm = 3.0;
    double roughness_um = 0.0;
    double correlation_mm = 1.0;
    double bow_mm = 0.0;
    double height_mm = 450.0;
    double tilt_deg = 0.0;
    double slope_mhz_us = 150.0;    ///< of the chirp; unless asked for, the radar file's
    double noise_figure_db = 12.0;  ///< likewise
    double leakage_db = 0.0;        ///< over the radar file's
    bool leakage = true;
    double session = 1.0;  ///< 0: the bench drawing, without room and mounting errors
    double frame = 0.0;    ///< of that session, or seed of the noise
};

/// A number of a request, with what the page's slider has to know.
struct NumberField {
    const char* key;
    const char* title;
    const char* unit;
    double min, max, step;
    bool whole;
    double SceneRequest::*member;
};

inline constexpr std::array<NumberField, 12> number_fields{{
    {"size_mm", "Size", "mm", 50, 600, 5, false, &SceneRequest::size_mm},
    {"thickness_mm", "Thickness", "mm", 0.1, 50, 0.05, false, &SceneRequest::thickness_mm},
    {"roughness_um", "Roughness (rms)", "µm", 0, 1000, 1, false, &SceneRequest::roughness_um},
    {"correlation_mm", "Correlation length", "mm", 0.1, 20, 0.1, false,
     &SceneRequest::correlation_mm},
    {"bow_mm", "Bow", "mm", -5, 5, 0.05, false, &SceneRequest::bow_mm},
    {"height_mm", "Height", "mm", 150, 1000, 1, false, &SceneRequest::height_mm},
    {"tilt_deg", "Tilt", "deg", -30, 30, 0.1, false, &SceneRequest::tilt_deg},
    {"slope_mhz_us", "Chirp slope", "MHz/µs", 20, 400, 1, false, &SceneRequest::slope_mhz_us},
    {"noise_figure_db", "Noise figure", "dB", 0, 50, 0.5, false, &SceneRequest::noise_figure_db},
    {"leakage_db", "Leakage level", "dB", -40, 20, 1, false, &SceneRequest::leakage_db},
    {"session", "Session", "", 0, 40, 1, true, &SceneRequest::session},
    {"frame", "Frame", "", 0, 59, 1, true, &SceneRequest::frame},
}};

/// What is wrong with one field of a request, and what would do.
class FieldError : public std::runtime_error {
  public:
    FieldError(std::string field, const std::string& problem, std::string remedy)
        : std::runtime_error(problem), field_(std::move(field)), remedy_(std::move(remedy)) {}
    const std::string& field() const { return field_; }
    const std::string& remedy() const { return remedy_; }

  private:
    std::string field_;
    std::string remedy_;
};

/// The names and radars that requests may use, read once.
struct KnownNames {
    std::vector<std::string> materials;
    std::vector<Radar> radars;  ///< whose frames the firmware takes

    static KnownNames of(const Catalogue& catalogue);
    const Radar* radar(const std::string& name) const;
};

/// The text of a request as JSON: an object without deep nests. Throws FieldError.
FloatJson parse_json(const std::string& text);

/// An object with the keys of a request, each with a default. Throws FieldError for unknown keys,
/// wrong types, and values out of range, with the range and its unit.
SceneRequest read_request(const FloatJson& json, const KnownNames& known);

/// The keys and values of a request, as read_request takes them.
FloatJson request_json(const SceneRequest& request);

}  // namespace specula
