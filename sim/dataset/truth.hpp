#pragma once

#include <array>
#include <cstdint>

namespace specula {

/// What made one frame, in full.
struct Truth {
    std::uint8_t label = 0;
    std::int32_t world = 0;
    std::int32_t sample = 0;   ///< physical piece, unique in an experiment
    std::int32_t session = 0;  ///< one placement and warm-up, unique in an experiment
    std::int32_t frame = 0;    ///< in the session
    std::int32_t view = 0;     ///< side or place from which recordings look at their samples

    double height_m = 0.0;
    double nominal_height_m = 0.0;
    double sensor_tilt_x_rad = 0.0;
    double sensor_tilt_y_rad = 0.0;
    double sample_tilt_x_rad = 0.0;
    double sample_tilt_y_rad = 0.0;
    double offset_x_m = 0.0;
    double offset_y_m = 0.0;
    double yaw_rad = 0.0;
    double size_x_m = 0.0;
    double size_y_m = 0.0;
    double thickness_m = 0.0;
    double bow_m = 0.0;
    double roughness_m = 0.0;
    double correlation_m = 0.0;
    double permittivity_factor = 1.0;
    double loss_factor = 1.0;
    double gain_db = 0.0;  ///< of session and frame together
    double displacement_m = 0.0;
};

/// A column of the file's /truth group.
struct TruthColumn {
    const char* name;
    const char* unit;
    const char* meaning;
    double Truth::*member;
};

/// All columns, in the order of the file. FORMAT.md lists them for readers.
inline constexpr std::array<TruthColumn, 19> truth_columns{{
    {"height_m", "m", "phase centre above the untilted face", &Truth::height_m},
    {"nominal_height_m", "m", "height asked for", &Truth::nominal_height_m},
    {"sensor_tilt_x_rad", "rad", "sensor about its x axis", &Truth::sensor_tilt_x_rad},
    {"sensor_tilt_y_rad", "rad", "sensor about its y axis", &Truth::sensor_tilt_y_rad},
    {"sample_tilt_x_rad", "rad", "sample about the pivot, x", &Truth::sample_tilt_x_rad},
    {"sample_tilt_y_rad", "rad", "sample about the pivot, y", &Truth::sample_tilt_y_rad},
    {"offset_x_m", "m", "centre of the sample beside the axis, x", &Truth::offset_x_m},
    {"offset_y_m", "m", "centre of the sample beside the axis, y", &Truth::offset_y_m},
    {"yaw_rad", "rad", "sample turned in its plane", &Truth::yaw_rad},
    {"size_x_m", "m", "sample size, x", &Truth::size_x_m},
    {"size_y_m", "m", "sample size, y", &Truth::size_y_m},
    {"thickness_m", "m", "sample thickness", &Truth::thickness_m},
    {"bow_m", "m", "edge midpoints below the centre", &Truth::bow_m},
    {"roughness_m", "m", "rms height of the face", &Truth::roughness_m},
    {"correlation_m", "m", "correlation length of the face's heights", &Truth::correlation_m},
    {"permittivity_factor", "1", "of this piece over the library's", &Truth::permittivity_factor},
    {"loss_factor", "1", "loss tangent over the library's", &Truth::loss_factor},
    {"gain_db", "dB", "receiver gain off nominal", &Truth::gain_db},
    {"displacement_m", "m", "sample away from the radar", &Truth::displacement_m},
}};

}  // namespace specula
