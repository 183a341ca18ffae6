#include "sim/trace/trace.hpp"

#include <algorithm>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/trace/edge_trace.hpp"
#include "sim/trace/gauss_legendre.hpp"
#include "sim/trace/many_surfaces.hpp"
#include "sim/trace/quadrature.hpp"
#include "sim/trace/route_collector.hpp"
#include "sim/trace/thin_plate.hpp"

namespace specula {

namespace {

/// A surface that no looked-at point of is reached over mirrors is taken as unreached.
constexpr int looks_at_surface = 16;
/// Follows one source (the TX or an image) over one face to one RX.
class FaceTracer {
  public:
    struct Task {
        int face;
        Mirrors mirrors;
        std::size_t rx;
    };

    FaceTracer(const Target& target, const AntennaSet& antennas, const TraceSettings& settings,
               RouteCollector& routes)
        : target_(target),
          antennas_(antennas),
          settings_(settings),
          wavelength_m_(speed_of_light_m_s / settings.highest_hz),
          routes_(routes) {}

    void add(const Task& task) {
        const auto& surfaces = target_.faces()[static_cast<std::size_t>(task.face)].surfaces;
        if (surfaces.size() >= ManySurfaces::fewest && is_plain(task)) {
            const auto alone = [&](const Surface& surface, const Patch& patch) {
                add(task, surface, patch);
            };
            return ManySurfaces(target_, antennas_, settings_, routes_)
                .add({task.face, task.rx}, alone);
        }
        for (const Surface& surface : surfaces)
            if (task.mirrors.faces.empty() || is_reached(task, surface))
                for (const Patch& patch : patches_of(surface)) add(task, surface, patch);
    }

  private:
    using Walks = std::vector<std::optional<Walk>>;

    PhaseCentres centres(const Task& task) const {
        return {task.mirrors.source(), antennas_.rx[task.rx].position_m};
    }

    bool is_reached(const Task& task, const Surface& surface) const {
        for (const WeightedPoint& p : points_on(surface, {}, {looks_at_surface, looks_at_surface}))
            if (walk(target_, task.mirrors, {p.point_m, p.normal, task.face}, centres(task).rx_m))
                return true;
        return false;
    }

    /// With nothing but opaque bodies and no mirrors, packets of shadow rays say it all.
    bool is_plain(const Task& task) const {
        return task.mirrors.faces.empty() &&
               (target_.faces().size() == 1 ||
                std::all_of(target_.bodies().begin(), target_.bodies().end(),
                            [](const Body& body) { return body.opaque; }));
    }

    Walks plain_walks(const Task& task, const std::vector<WeightedPoint>& points) const {
        const PhaseCentres ends = centres(task);
        std::vector<Vector3> places;
        std::vector<char> clear;
        Walks walks(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const WeightedPoint& p = points[i];
            Walk straight;
            straight.leaving = straight.arriving = (p.point_m - ends.source_m).normalized();
            const bool at_back = straight.arriving.dot(p.normal) > 0.0;
            straight.normal = at_back ? Vector3(-p.normal) : p.normal;
            straight.from_behind = at_back && !target_.body_of(task.face).opaque;
            straight.signature = at_back;
            places.push_back(p.point_m);
            clear.push_back(straight.normal.dot(ends.rx_m - p.point_m) > 0.0 &&
                            straight.normal.dot(straight.arriving) < 0.0);
            walks[i] = std::move(straight);
        }
        target_.geometry().shadow(ends.source_m, places, clear);
        target_.geometry().shadow(ends.rx_m, places, clear);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!clear[i]) walks[i].reset();
        return walks;
    }

    Walks walks_to(const Task& task, const std::vector<WeightedPoint>& points) const {
        if (is_plain(task)) return plain_walks(task, points);
        Walks walks;
        for (const WeightedPoint& p : points)
            walks.push_back(
                walk(target_, task.mirrors, {p.point_m, p.normal, task.face}, centres(task).rx_m));
        return walks;
    }

    static bool all_alike(const Walks& walks) {
        return std::all_of(walks.begin(), walks.end(), [&](const std::optional<Walk>& w) {
            return w.has_value() == walks.front().has_value() &&
                   (!w || w->signature == walks.front()->signature);
        });
    }

    /// Where the integral needs few points only, do the ways between them meet the same faces too?
    bool alike_between(const Task& task, const Surface& surface, const Patch& patch,
                       PointCount count, const Walks& walks) const {
        if (target_.faces().size() == 1 || std::min(count.u, count.v) >= fewest_ways) return true;
        Walks more = walks_to(
            task, points_on(surface, patch,
                            {std::max(count.u, fewest_ways), std::max(count.v, fewest_ways)}));
        more.push_back(walks.front());
        return all_alike(more);
    }

    void add(const Task& task, const Surface& surface, const Patch& patch) {
        const PointCount count =
            points_needed(surface, patch, centres(task), wavelength_m_, settings_.accuracy_db);
        if (count.u > largest_gauss_rule || count.v > largest_gauss_rule)
            return add_halves(task, surface, patch, count.u > count.v);
        const std::vector<WeightedPoint> points = points_on(surface, patch, count);
        const Walks walks = walks_to(task, points);
        if (!all_alike(walks) || !alike_between(task, surface, patch, count, walks)) {
            const SurfacePoint middle = surface_point(surface, patch.u_at(0.0), patch.v_at(0.0));
            const double size_u = 2.0 * patch.half_u() * middle.along_u.norm();
            const double size_v = 2.0 * patch.half_v() * middle.along_v.norm();
            if (std::max(size_u, size_v) > smallest_cut_wavelengths * wavelength_m_)
                return add_halves(task, surface, patch, size_u > size_v);
        }
        const int body = target_.faces()[static_cast<std::size_t>(task.face)].body;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (walks[i]) routes_.add(points[i], body, *walks[i], task.mirrors.source(), task.rx);
    }

    void add_halves(const Task& task, const Surface& surface, const Patch& patch, bool across_u) {
        Patch first = patch, second = patch;
        if (across_u)
            first.u[1] = second.u[0] = patch.u_at(0.0);
        else
            first.v[1] = second.v[0] = patch.v_at(0.0);
        add(task, surface, first);
        add(task, surface, second);
    }

    const Target& target_;
    const AntennaSet& antennas_;
    TraceSettings settings_;
    double wavelength_m_;
    RouteCollector& routes_;
};

/// Calls `use` with every sequence of flat faces of up to `most` mirrors, the empty one first.
template <typename Use>
void for_each_mirrors(const Target& target, const Mirrors& so_far, int most, const Use& use) {
    use(so_far);
    if (static_cast<int>(so_far.faces.size()) == most) return;
    for (std::size_t i = 0; i < target.faces().size(); ++i) {
        const int face = static_cast<int>(i);
        const bool again = !so_far.faces.empty() && so_far.faces.back() == face;
        if (target.faces()[i].flat && !again)
            for_each_mirrors(target, so_far.with(face, target), most, use);
    }
}

Scatter trace_faces(const Target& target, const AntennaSet& antennas,
                    const TraceSettings& settings) {
    RouteCollector routes(target, antennas);
    FaceTracer tracer(target, antennas, settings, routes);
    const int most_mirrors = target.faces().size() == 1 ? 0 : settings.max_bounces - 1;
    for_each_mirrors(target, no_mirrors(antennas.tx.position_m), most_mirrors,
                     [&](const Mirrors& mirrors) {
                         for (std::size_t face = 0; face < target.faces().size(); ++face) {
                             const int number = static_cast<int>(face);
                             if (!mirrors.faces.empty() && mirrors.faces.back() == number) continue;
                             for (std::size_t rx = 0; rx < antennas.rx.size(); ++rx)
                                 tracer.add({number, mirrors, rx});
                         }
                     });
    return routes.take();
}

}  // namespace

Scatter trace(const Target& target, const AntennaSet& antennas, const TraceSettings& settings) {
    SPECULA_EXPECT(settings.highest_hz > 0.0 && settings.accuracy_db > 0.0);
    std::optional<ThinPlate> plate = ThinPlate::of(target, antennas, settings);
    return trace(target, antennas, settings, plate);
}

Scatter trace(const Target& target, const AntennaSet& antennas, const TraceSettings& settings,
              std::optional<ThinPlate>& plate) {
    SPECULA_EXPECT(settings.highest_hz > 0.0 && settings.accuracy_db > 0.0);
    std::optional<Scatter> thin = plate ? plate->echo() : std::nullopt;
    Scatter scatter = thin ? std::move(*thin) : trace_faces(target, antennas, settings);
    if (settings.edge_currents) scatter.edges = trace_edges(target, antennas, settings);
    return scatter;
}

}  // namespace specula
