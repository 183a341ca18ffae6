#include "tools/validate/verdict.hpp"

#include <algorithm>

namespace specula {

std::string verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            break;
        case Verdict::fail:
            return "FAIL";
        case Verdict::not_computable:
            return "cannot compute";
    }
    return "pass";
}

namespace {

/// The verdict on several parts.
template <typename Parts>
Verdict verdict_on(const Parts& parts) {
    Verdict verdict = Verdict::pass;
    for (const auto& part : parts) {
        const Verdict own = part.verdict();
        if (own == Verdict::fail) return own;
        if (own == Verdict::not_computable) verdict = own;
    }
    return verdict;
}

template <typename Parts>
std::size_t number_with(const Parts& parts, Verdict verdict) {
    return static_cast<std::size_t>(std::count_if(
        parts.begin(), parts.end(), [&](const auto& part) { return part.verdict() == verdict; }));
}

}  // namespace

Verdict PointVerdict::verdict() const {
    if (!problem.empty()) return Verdict::not_computable;
    const bool all = std::all_of(quantities.begin(), quantities.end(),
                                 [](const Quantity& quantity) { return quantity.passes(); });
    return all ? Verdict::pass : Verdict::fail;
}

const Quantity* PointVerdict::worst() const {
    const Quantity* worst = nullptr;
    for (const Quantity& quantity : quantities)
        if (quantity.judged && (worst == nullptr || quantity.share() > worst->share()))
            worst = &quantity;
    return worst;
}

Verdict CaseVerdict::verdict() const {
    return verdict_on(points);
}

std::size_t CaseVerdict::worst_point() const {
    std::size_t found = 0;
    double largest = -1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Quantity* quantity = points[i].worst();
        if (quantity == nullptr || quantity->share() <= largest) continue;
        largest = quantity->share();
        found = i;
    }
    return found;
}

const Quantity* CaseVerdict::worst() const {
    return points.empty() ? nullptr : points[worst_point()].worst();
}

std::size_t CaseVerdict::n_points_with(Verdict verdict) const {
    return number_with(points, verdict);
}

std::size_t CaseVerdict::n_shown_only() const {
    std::size_t n = 0;
    for (const PointVerdict& point : points)
        n += static_cast<std::size_t>(
            std::count_if(point.quantities.begin(), point.quantities.end(),
                          [](const Quantity& quantity) { return !quantity.judged; }));
    return n;
}

std::size_t Validation::n_points() const {
    std::size_t n = 0;
    for (const CaseVerdict& each : cases) n += each.points.size();
    return n;
}

std::size_t Validation::n_cases_with(Verdict verdict) const {
    return number_with(cases, verdict);
}

Verdict Validation::verdict() const {
    return verdict_on(cases);
}

int Validation::exit_status() const {
    switch (verdict()) {
        case Verdict::pass:
            break;
        case Verdict::fail:
            return 1;
        case Verdict::not_computable:
            return 3;
    }
    return 0;
}

}  // namespace specula
