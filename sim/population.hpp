#pragma once

#include <string>
#include <vector>

#include "scenes/catalogue.hpp"
#include "scenes/sample.hpp"
#include "sim/core/distribution.hpp"

namespace specula {

/// A class of the experiment and the laws of its physical samples.
struct SampleLaw {
    std::string name;  ///< class name
    Sample nominal;    ///< material, size, backing; the rest is drawn
    Distribution thickness_m;
    Distribution bow_m;
    Distribution roughness_m;
    Distribution correlation_m{SampleLayer::usual_correlation_m};
    Distribution permittivity_factor{1.0};
    Distribution loss_factor{1.0};
};

/// How a session differs from the bench drawing: the sample is put down again, the board has
/// warmed up, someone moved a chair.
struct SessionLaw {
    Distribution height_m;  ///< error of the height
    Distribution tilt_rad;  ///< error of the sample's tilt, each axis
    Distribution offset_m;  ///< error of the sample's place, each axis
    Distribution yaw_rad;
    Distribution gain_db;
    Distribution leakage_db;
    Distribution leakage_rad;
    Distribution gain_drift_db{};     ///< from the first frame to the last
    Distribution leakage_drift_db{};  ///< likewise, for each RX
    Distribution leakage_drift_rad{};

    bool board_drifts() const;
};

/// How a frame differs from its session.
struct FrameLaw {
    Distribution displacement_m;
    Distribution gain_db;
    Distribution velocity_m_s{};
    Distribution vibration_m{};  ///< peak, within the frame
    Distribution vibration_hz{};
};

/// Small things in the room, each a point with a complex Gaussian amplitude.
struct ClutterLaw {
    int points = 0;
    double level_db = -45.0;  ///< mean power of each, relative to a mirror at the nominal height
    Distribution range_m;
};

/// Everything that varies, from the outside in: world > sample > session > frame.
struct Population {
    std::vector<SampleLaw> classes;
    SessionLaw session;
    FrameLaw frame;
    ClutterLaw world_clutter;
    ClutterLaw session_clutter;

    std::vector<std::string> class_names() const;
};

/// Reads [frame], or another section with its keys.
FrameLaw read_frame(Section section);

/// Reads [sample], [[class]], and of [session], [frame], [world_clutter] and [session_clutter] those
/// that are there: nothing varies by the others.
Population read_population(Section& experiment, const Catalogue& catalogue);

}  // namespace specula
