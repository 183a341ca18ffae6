#include "sim/channel/channel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/channel/coefficients.hpp"
#include "sim/channel/edge_channel.hpp"
#include "sim/channel/material_channels.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr Complex surface_factor{0.0, -1.0 / (8.0 * pi)};

double wavenumber_rad_m(double frequency_hz) {
    return two_pi * frequency_hz / speed_of_light_m_s;
}

std::vector<Event> events_of(const Route& route) {
    std::vector<Event> events = route.before;
    events.insert(events.end(), route.after.begin(), route.after.end());
    return events;
}

/// Where the angle dependence is looked at, to see how many polynomials it needs.
std::array<double, 5> looks_of(const FrequencyComb& comb) {
    return {comb.first_hz, comb.at(comb.n / 4), comb.at(comb.n / 2), comb.at(3 * comb.n / 4),
            comb.last_hz()};
}

/// Any route, every coefficient worked out where it is needed: for what no short series describes.
void add_plainly(const RouteScatter& route, std::span<const Reflector> reflectors,
                 const FrequencyComb& comb, const ForEach& for_each, Channel& channel) {
    const Scatter alone{.n_rx = channel.n_rx, .routes = {route}};
    for_each(static_cast<std::size_t>(comb.n), [&](std::size_t number) {
        const int i = static_cast<int>(number);
        for (int rx = 0; rx < channel.n_rx; ++rx)
            channel.of_rx(rx)[i] += direct_sum(alone, rx, reflectors, comb.at(i));
    });
}

/// The interval and number of polynomials of each event, and of the currents, which come last.
std::vector<ChebyshevGrid> route_cosines(const RouteScatter& scatter,
                                         std::span<const Reflector> reflectors,
                                         const FrequencyComb& comb) {
    const auto looks_hz = looks_of(comb);
    std::vector<ChebyshevGrid> grids;
    const auto add = [&](const Event& event, const Scatter::Extent& extent) {
        ChebyshevGrid grid{extent.low, extent.high, 1};
        const Reflector& reflector = reflectors[static_cast<std::size_t>(event.body)];
        grid.n = polynomials_needed(event, reflector, looks_hz, grid);
        grids.push_back(grid);
    };
    const std::vector<Event> events = events_of(scatter.route);
    for (std::size_t e = 0; e < events.size(); ++e) add(events[e], event_cosine_extent(scatter, e));
    add(currents_of(scatter.route), cosine_extent(scatter));
    return grids;
}

TeTm value_of(const AngularSeries& series, const ChebyshevGrid& grid, double cosine) {
    std::array<double, most_polynomials> polynomials{};
    const auto n = series.te.size();
    chebyshev_polynomials(grid.unit(cosine), std::span(polynomials).first(n));
    TeTm value{};
    for (std::size_t k = 0; k < n; ++k) {
        value.te += series.te[k] * polynomials[k];
        value.tm += series.tm[k] * polynomials[k];
    }
    return value;
}

/// Sum over weights of weight times coefficients, with the coefficients of each event in hand.
Complex point_sum(const PairScatter& pair, std::size_t point, std::span<const TeTm> events,
                  std::size_t n_before, const TeTm& currents) {
    const std::size_t n_after = events.size() - n_before;
    const Complex parts[3] = {1.0, currents.te, currents.tm};
    Complex sum = 0.0;
    for (std::size_t w = 0; w < pair.weight.size(); ++w) {
        const std::size_t after = w & ((std::size_t{1} << n_after) - 1);
        const std::size_t part = (w >> n_after) % 3, before = (w >> n_after) / 3;
        Complex product = parts[part];
        for (std::size_t e = 0; e < n_before; ++e)
            product *= before >> (n_before - 1 - e) & 1u ? events[e].tm : events[e].te;
        for (std::size_t e = 0; e < n_after; ++e)
            product *=
                after >> (n_after - 1 - e) & 1u ? events[n_before + e].tm : events[n_before + e].te;
        sum += pair.weight[w][point] * product;
    }
    return sum;
}

/// A route over mirrors or through sheets: summed at every frequency.
void add_eventful(const RouteScatter& scatter, std::span<const Reflector> reflectors,
                  const FrequencyComb& comb, const ForEach& for_each, Channel& channel) {
    const std::vector<Event> events = events_of(scatter.route);
    const std::vector<ChebyshevGrid> grids = route_cosines(scatter, reflectors, comb);
    const auto unwieldy = [](const ChebyshevGrid& grid) { return grid.n == 0; };
    if (std::any_of(grids.begin(), grids.end(), unwieldy))
        return add_plainly(scatter, reflectors, comb, for_each, channel);
    for_each(static_cast<std::size_t>(comb.n), [&](std::size_t number) {
        const int i = static_cast<int>(number);
        std::vector<TeTm> at(events.size());
        std::vector<AngularSeries> series;
        for (std::size_t e = 0; e < grids.size(); ++e) {
            const Event event = e < events.size() ? events[e] : currents_of(scatter.route);
            const Stack stack = reflectors[static_cast<std::size_t>(event.body)](comb.at(i));
            series.push_back(angular_series(event, stack, grids[e]));
        }
        const double k = wavenumber_rad_m(comb.at(i));
        for (int rx = 0; rx < channel.n_rx; ++rx) {
            const PairScatter& pair = scatter.rx[static_cast<std::size_t>(rx)];
            Complex sum = 0.0;
            for (std::size_t point = 0; point < pair.path_m.size(); ++point) {
                for (std::size_t e = 0; e < events.size(); ++e)
                    at[e] = value_of(series[e], grids[e], pair.event_cosine[e][point]);
                const TeTm currents =
                    value_of(series.back(), grids.back(), pair.cos_incidence[point]);
                sum += pair.wave(point, k) *
                       point_sum(pair, point, at, scatter.route.before.size(), currents);
            }
            channel.of_rx(rx)[i] += surface_factor * sum;
        }
    });
}

double reference_path_m(const Scatter& scatter) {
    Scatter::Extent all;
    for (const RouteScatter& route : scatter.routes) {
        if (route.route.n_events() > 0) continue;
        const Scatter::Extent extent = path_extent_m(route);
        if (extent.high == 0.0) continue;
        all.low = all.high == 0.0 ? extent.low : std::min(all.low, extent.low);
        all.high = std::max(all.high, extent.high);
    }
    return 0.5 * (all.low + all.high);
}

}  // namespace

MaterialChannels::MaterialChannels(const Scatter& scatter, const FrequencyComb& comb)
    : scatter_(scatter), comb_(comb), reference_path_m_(reference_path_m(scatter)) {
    for (const RouteScatter& route : scatter.routes)
        if (route.route.n_events() == 0) straight_.emplace_back(route, comb);
}

Channel MaterialChannels::channel(std::span<const Reflector> reflectors, const ForEach& for_each) {
    Channel channel{.n_rx = scatter_.n_rx,
                    .n_frequencies = comb_.n,
                    .h = std::vector<Complex>(static_cast<std::size_t>(scatter_.n_rx) *
                                              static_cast<std::size_t>(comb_.n)),
                    .reference_path_m = reference_path_m_};
    std::size_t straight = 0;
    for (const RouteScatter& route : scatter_.routes) {
        const Reflector& reflector = reflectors[static_cast<std::size_t>(route.route.body)];
        if (route.route.n_events() > 0)
            add_eventful(route, reflectors, comb_, for_each, channel);
        else if (!straight_[straight++].add(reflector, channel))
            add_plainly(route, reflectors, comb_, for_each, channel);
    }
    add_edges(scatter_, reflectors, comb_, channel);
    return channel;
}

Channel channel_of(const Scatter& scatter, std::span<const Reflector> reflectors,
                   const FrequencyComb& comb, const ForEach& for_each) {
    return MaterialChannels(scatter, comb).channel(reflectors, for_each);
}

Complex direct_sum(const Scatter& scatter, int rx, std::span<const Reflector> reflectors,
                   double frequency_hz) {
    Complex sum = 0.0;
    const double k = wavenumber_rad_m(frequency_hz);
    for (const RouteScatter& route : scatter.routes) {
        const std::vector<Event> events = events_of(route.route);
        const PairScatter& pair = route.rx[static_cast<std::size_t>(rx)];
        const auto stack_of = [&](const Event& event) {
            return reflectors[static_cast<std::size_t>(event.body)](frequency_hz);
        };
        const Event currents = currents_of(route.route);
        const Stack currents_stack = stack_of(currents);
        std::vector<Stack> stacks;
        for (const Event& event : events) stacks.push_back(stack_of(event));
        std::vector<TeTm> at(events.size());
        for (std::size_t point = 0; point < pair.path_m.size(); ++point) {
            for (std::size_t e = 0; e < events.size(); ++e)
                at[e] = coefficients_of(events[e], stacks[e], pair.event_cosine[e][point]);
            sum += pair.wave(point, k) *
                   point_sum(pair, point, at, route.route.before.size(),
                             coefficients_of(currents, currents_stack, pair.cos_incidence[point]));
        }
    }
    return surface_factor * sum + edge_sum(scatter, rx, reflectors, frequency_hz);
}

}  // namespace specula
