#include "sim/trace/walk.hpp"

#include <algorithm>

namespace specula {

namespace {

constexpr int next_leg = -1;  ///< between the legs in a signature
constexpr int behind = -2;

void sign(std::uint64_t& signature, int mark) {
    signature = (signature ^ static_cast<std::uint32_t>(mark)) * 1099511628211ull;  // FNV-1a
}
constexpr std::size_t most_sheets = 4;

double height_above(const Face& face, const Vector3& point) {
    return face.normal.dot(point - face.point_m);
}

/// The transmissions on a straight leg, in the wave's order; nothing when something opaque is on
/// it.
std::optional<std::vector<EventAt>> sheets_between(const Target& target, const Vector3& from,
                                                   const Vector3& to, std::uint64_t& signature) {
    std::vector<EventAt> events;
    for (const int number : target.geometry().crossings(from, to)) {
        const Face& face = target.faces()[static_cast<std::size_t>(number)];
        if (target.body_of(number).opaque || events.size() == most_sheets) return std::nullopt;
        sign(signature, number);
        const Vector3 direction = (to - from).normalized();
        events.push_back({{.kind = Event::Kind::transmit,
                           .body = face.body,
                           .from_behind = direction.dot(face.normal) > 0.0},
                          direction,
                          face.normal});
    }
    sign(signature, next_leg);
    return events;
}

}  // namespace

Mirrors no_mirrors(const Vector3& tx_m) {
    return {{}, {tx_m}};
}

Mirrors Mirrors::with(int number, const Target& target) const {
    const Face& face = target.faces()[static_cast<std::size_t>(number)];
    Mirrors longer = *this;
    longer.faces.push_back(number);
    longer.images.push_back(source() - 2.0 * height_above(face, source()) * face.normal);
    return longer;
}

std::optional<Walk> walk(const Target& target, const Mirrors& mirrors, const PointOnFace& on,
                         const Vector3& rx_m) {
    const auto& [point, normal, face_number] = on;
    Walk found;
    // Backwards from the point: each leg aims at the image behind the mirror before it.
    std::vector<EventAt> backwards;
    Vector3 end = point;
    for (std::size_t i = mirrors.faces.size() + 1; i-- > 0;) {
        const Vector3& source = mirrors.images[i];
        Vector3 start = source;
        if (i > 0) {
            const Face& face = target.faces()[static_cast<std::size_t>(mirrors.faces[i - 1])];
            const double above_end = height_above(face, end);
            const double above_source = height_above(face, mirrors.images[i - 1]);
            if (!(above_end * above_source > 0.0)) return std::nullopt;
            start = end + (source - end) * (above_end / (above_end + above_source));
            if (!target.geometry().holds(mirrors.faces[i - 1], start, (end - start).normalized()))
                return std::nullopt;
        }
        const auto sheets = sheets_between(target, start, end, found.signature);
        if (!sheets) return std::nullopt;
        backwards.insert(backwards.end(), sheets->rbegin(), sheets->rend());
        if (i == mirrors.faces.size()) found.arriving = (end - start).normalized();
        if (i == 0) {
            found.leaving = (end - start).normalized();
        } else {
            const Face& face = target.faces()[static_cast<std::size_t>(mirrors.faces[i - 1])];
            const Vector3 after = (end - start).normalized();
            const Vector3 before = after - 2.0 * after.dot(face.normal) * face.normal;
            backwards.push_back(
                {{.kind = Event::Kind::reflect,
                  .body = face.body,
                  .from_behind = !target.bodies()[static_cast<std::size_t>(face.body)].opaque &&
                                 before.dot(face.normal) > 0.0},
                 before,
                 face.normal});
        }
        end = start;
    }
    found.before.assign(backwards.rbegin(), backwards.rend());

    const bool at_back = found.arriving.dot(normal) > 0.0;
    found.normal = at_back ? Vector3(-normal) : normal;
    found.from_behind = at_back && !target.body_of(face_number).opaque;
    if (!(found.normal.dot(rx_m - point) > 0.0) || !(found.normal.dot(found.arriving) < 0.0))
        return std::nullopt;
    if (at_back) sign(found.signature, behind);
    auto after = sheets_between(target, point, rx_m, found.signature);
    if (!after) return std::nullopt;
    found.after = std::move(*after);
    return found;
}

}  // namespace specula
