#pragma once

#include <complex>
#include <vector>

namespace specula {

/// Something that happens to a wave on its way and multiplies it by a coefficient of a body.
struct Event {
    enum class Kind { reflect, transmit, scatter };  ///< scatter: by the heights of a rough face
    Kind kind = Kind::reflect;
    int body = 0;
    bool from_behind = false;  ///< the wave comes from the back of a sheet
    int face = 0;              ///< of the body's stack, from the top, where it scatters

    bool operator==(const Event&) const = default;
};

/// Which way a group of points is reached, and which way it is left.
struct Route {
    std::vector<Event> before;  ///< between TX and the point, in the wave's order
    int body = 0;               ///< whose surface currents radiate
    bool from_behind = false;
    std::vector<Event> after;  ///< between the point and the RX: transmissions
    int rough_face = mirror;   ///< face of the body's stack whose heights scatter, or `mirror`

    static constexpr int mirror = -1;  ///< the currents are those of the coherent reflection

    bool operator==(const Route&) const = default;
    std::size_t n_events() const { return before.size() + after.size(); }
    /// Each event splits the wave into its TE and its TM part; the currents take 1, r_TE or r_TM.
    std::size_t n_weights() const { return std::size_t{3} << n_events(); }
};

/// The surface integral of one (tx, rx) pair along one route, as a sum over points, geometry only:
///
/// h(f) = -j/(8 pi) Sum_points factor exp(-j(k - centre) path) Sum_w weight_w Product of the
/// coefficients that w names
///
/// Weight w counts, from its lowest bits: TE or TM of the events `after`, then incident / TE / TM
/// of the currents, then TE or TM of the events `before`.
/// @eq PHYSICS.md#surface-integral
struct PairScatter {
    std::vector<double> path_m;                     ///< (point) TX to point to RX, unfolded
    std::vector<double> cos_incidence;              ///< (point) where the currents are
    std::vector<std::vector<double>> event_cosine;  ///< (event, point): before, then after
    std::vector<std::vector<double>> weight;        ///< (weight, point), dimensionless
    std::vector<std::complex<double>> factor{};     ///< (point); empty: 1 everywhere
    double centre_rad_m = 0.0;                      ///< wave number that `factor` holds at

    /// factor exp(-j(k - centre) path)
    std::complex<double> wave(std::size_t point, double wavenumber_rad_m) const {
        const auto turned = std::polar(1.0, (centre_rad_m - wavenumber_rad_m) * path_m[point]);
        return factor.empty() ? turned : factor[point] * turned;
    }
};

struct RouteScatter {
    Route route;
    std::vector<PairScatter> rx;  ///< (rx)
};

/// What the free edges of a body add to physical optics, when it is a perfect conductor:
///
/// h(f) = -j/(8 pi) Sum_points weight exp(-jk path) / (jk)
///
/// `weight` has one row, in 1/m; the cosines are empty.
/// @eq PHYSICS.md#edge-currents
struct EdgeScatter {
    int body = 0;
    std::vector<PairScatter> rx;  ///< (rx)
};

/// What the radar sees: no material in it, so that one trace serves any of them.
struct Scatter {
    int n_rx = 0;
    std::vector<RouteScatter> routes;
    std::vector<EdgeScatter> edges{};

    struct Extent {
        double low = 0.0;
        double high = 0.0;
    };
    std::size_t n_points() const;
};

/// Over all pairs of a route; {0, 0} when there is no point.
Scatter::Extent path_extent_m(const RouteScatter& scatter);
Scatter::Extent cosine_extent(const RouteScatter& scatter);
/// Of event number `event`, before and after counted through.
Scatter::Extent event_cosine_extent(const RouteScatter& scatter, std::size_t event);

}  // namespace specula
