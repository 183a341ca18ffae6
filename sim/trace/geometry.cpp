#include "sim/trace/geometry.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/trace/way_packet.hpp"

namespace specula {

namespace {

/// SPECULA_EMBREE adds to it, e.g. "isa=sse2": for comparing what processors of other generations
/// make of a scene (tests/tools/generate/other_processor_test.sh).
std::string device_configuration() {
    const char* more = std::getenv("SPECULA_EMBREE");
    return std::string("threads=1") + (more ? "," + std::string(more) : "");
}

/// One device for the whole program: a second one would start threads of its own.
RTCDevice device() {
    static const RTCDevice shared = [] {
        const RTCDevice made = rtcNewDevice(device_configuration().c_str());
        if (!made) throw SystemError("Embree could not start on this machine");
        return made;
    }();
    return shared;
}

void occluded(RTCScene scene, const int* valid, RTCRay16& rays) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded16(valid, scene, &rays);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(valid, scene, &context, &rays);
#endif
}

bool occluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#endif
    return ray.tfar < 0.0f;  // Embree's mark of a hit
}

bool intersect(RTCScene scene, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
    return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

void check(const Mesh& mesh) {
    for (const Vector3& vertex : mesh.vertices_m)
        if (!vertex.cast<float>().allFinite())
            throw InputError("a mesh has a vertex that is not finite in single precision");
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            if (index >= mesh.vertices_m.size())
                throw InputError(
                    format("a mesh of {} vertices names vertex {}", mesh.vertices_m.size(), index));
}

void attach(RTCScene scene, const Mesh& mesh) {
    const RTCGeometry triangles = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices_m.size()));
    for (const Vector3& vertex : mesh.vertices_m)
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(vertex[axis]);
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle) *indices++ = index;
    rtcCommitGeometry(triangles);
    rtcAttachGeometry(scene, triangles);
    rtcReleaseGeometry(triangles);
}

OwnFrame frame_of(const std::vector<Mesh>& meshes) {
    OwnFrame frame;
    std::size_t n = 0;
    for (const Mesh& mesh : meshes) {
        for (const Vector3& vertex : mesh.vertices_m) frame.origin_m += vertex;
        n += mesh.vertices_m.size();
    }
    if (n > 0) frame.origin_m /= static_cast<double>(n);
    for (const Mesh& mesh : meshes) {
        for (const auto& triangle : mesh.triangles) {
            const Vector3 a = mesh.vertices_m[triangle[0]];
            const Vector3 x = mesh.vertices_m[triangle[1]] - a;
            const Vector3 z = x.cross(mesh.vertices_m[triangle[2]] - a);
            if (!(z.norm() > 0.0)) continue;
            frame.to_own.row(0) = x.normalized();
            frame.to_own.row(1) = z.cross(x).normalized();
            frame.to_own.row(2) = z.normalized();
            return frame;
        }
    }
    return frame;
}

std::vector<Mesh> moved_into(const OwnFrame& frame, std::vector<Mesh> meshes) {
    for (Mesh& mesh : meshes)
        for (Vector3& vertex : mesh.vertices_m) vertex = frame.point(vertex);
    return meshes;
}

BoundingSphere sphere_around(const std::vector<Mesh>& meshes) {
    Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Mesh& mesh : meshes) {
        for (const Vector3& vertex : mesh.vertices_m) {
            low = low.cwiseMin(vertex);
            high = high.cwiseMax(vertex);
        }
    }
    if (!low.allFinite()) return {};
    return {0.5 * (low + high), 0.5 * (high - low).norm() + 0.01};
}

RTCRay16 rays_of(const WayPacket& packet) {
    RTCRay16 rays{};
    std::copy_n(packet.origin_x, packet_size, rays.org_x);
    std::copy_n(packet.origin_y, packet_size, rays.org_y);
    std::copy_n(packet.origin_z, packet_size, rays.org_z);
    std::copy_n(packet.direction_x, packet_size, rays.dir_x);
    std::copy_n(packet.direction_y, packet_size, rays.dir_y);
    std::copy_n(packet.direction_z, packet_size, rays.dir_z);
    std::copy_n(packet.near_m, packet_size, rays.tnear);
    std::copy_n(packet.far_m, packet_size, rays.tfar);
    std::fill_n(rays.mask, packet_size, ~0u);
    return rays;
}

RTCRay ray_of(const WayPacket& packet, std::size_t i) {
    RTCRay ray{};
    ray.org_x = packet.origin_x[i];
    ray.org_y = packet.origin_y[i];
    ray.org_z = packet.origin_z[i];
    ray.dir_x = packet.direction_x[i];
    ray.dir_y = packet.direction_y[i];
    ray.dir_z = packet.direction_z[i];
    ray.tnear = packet.near_m[i];
    ray.tfar = packet.far_m[i];
    ray.mask = ~0u;
    return ray;
}

RTCRayHit ray_along(const Way& way) {
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(way.origin.x());
    ray.ray.org_y = static_cast<float>(way.origin.y());
    ray.ray.org_z = static_cast<float>(way.origin.z());
    ray.ray.dir_x = static_cast<float>(way.direction.x());
    ray.ray.dir_y = static_cast<float>(way.direction.y());
    ray.ray.dir_z = static_cast<float>(way.direction.z());
    ray.ray.tnear = static_cast<float>(way.near_m);
    ray.ray.tfar = static_cast<float>(way.far_m);
    ray.ray.mask = ~0u;
    ray.hit.geomID = ray.hit.primID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return ray;
}

}  // namespace

struct Geometry::Held {
    RTCScene scene = rtcNewScene(device());
    OwnFrame frame;
    BoundingSphere around;  ///< in that frame
    ~Held() { rtcReleaseScene(scene); }

    Way way(const Vector3& from, const Vector3& to) const {
        return way_between(frame.point(from), frame.point(to), around);
    }
};

Geometry::Geometry(const std::vector<Mesh>& meshes) : held_(std::make_unique<Held>()) {
    for (const Mesh& mesh : meshes) check(mesh);
    held_->frame = frame_of(meshes);
    const std::vector<Mesh> own = moved_into(held_->frame, meshes);
    rtcSetSceneFlags(held_->scene, RTC_SCENE_FLAG_ROBUST);
    for (const Mesh& mesh : own) attach(held_->scene, mesh);
    rtcCommitScene(held_->scene);
    held_->around = sphere_around(own);
    if (const RTCError error = rtcGetDeviceError(device()); error != RTC_ERROR_NONE)
        throw SystemError(
            format("Embree could not take the scene (error {})", static_cast<int>(error)));
}

Geometry::~Geometry() = default;
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;

void Geometry::shadow(const Vector3& from, std::span<const Vector3> to,
                      std::span<char> clear) const {
    const WaySource source{held_->frame, held_->around, from};
    WayPacket packet;
    for (std::size_t first = 0; first < to.size(); first += packet_size) {
        const std::size_t n = std::min(packet_size, to.size() - first);
        make_ways(source, to.subspan(first, n), packet);
        RTCRay16 rays = rays_of(packet);
        occluded(held_->scene, packet.valid, rays);
        for (std::size_t i = 0; i < n; ++i)
            if (packet.valid[i] && rays.tfar[i] < 0.0f) clear[first + i] = 0;
    }
}

struct Geometry::ReadyRays {
    std::vector<WayPacket> packets;
};

std::shared_ptr<Geometry::ReadyRays> Geometry::made_ready(const Vector3& from,
                                                          std::span<const Vector3> to) const {
    const auto ready = std::make_shared<ReadyRays>();
    ready->packets.resize((to.size() + packet_size - 1) / packet_size);
    const WaySource source{held_->frame, held_->around, from};
    for (std::size_t p = 0; p < ready->packets.size(); ++p)
        make_ways(source,
                  to.subspan(p * packet_size, std::min(packet_size, to.size() - p * packet_size)),
                  ready->packets[p]);
    return ready;
}

std::size_t Geometry::n_blocked(const ReadyRays& rays, bool in_packets) const {
    std::size_t n = 0;
    for (const WayPacket& packet : rays.packets) {
        if (in_packets) {
            RTCRay16 all = rays_of(packet);
            occluded(held_->scene, packet.valid, all);
            for (std::size_t i = 0; i < packet_size; ++i)
                n += packet.valid[i] && all.tfar[i] < 0.0f;
            continue;
        }
        for (std::size_t i = 0; i < packet_size; ++i) {
            if (!packet.valid[i]) continue;
            RTCRay ray = ray_of(packet, i);
            n += occluded(held_->scene, ray);
        }
    }
    return n;
}

std::vector<int> Geometry::crossings(const Vector3& from, const Vector3& to) const {
    std::vector<int> crossed;
    Way way = held_->way(from, to);
    while (way.is_traceable() && static_cast<int>(crossed.size()) < most_crossings) {
        RTCRayHit ray = ray_along(way);
        if (!intersect(held_->scene, ray)) break;
        const int face = static_cast<int>(ray.hit.geomID);
        // Two triangles of one face share the edge that a ray may hit twice.
        if (crossed.empty() || crossed.back() != face) crossed.push_back(face);
        way.near_m = static_cast<double>(ray.ray.tfar) + end_margin_m;
    }
    return crossed;
}

bool Geometry::holds(int geometry, const Vector3& point, const Vector3& direction) const {
    const Vector3 along = held_->frame.direction(direction);
    Way way{held_->frame.point(point) - 2.0 * end_margin_m * along, along, 0.0, 4.0 * end_margin_m};
    while (way.is_traceable()) {
        RTCRayHit ray = ray_along(way);
        if (!intersect(held_->scene, ray)) return false;
        if (static_cast<int>(ray.hit.geomID) == geometry) return true;
        way.near_m = static_cast<double>(ray.ray.tfar) + 1e-6;
    }
    return false;
}

}  // namespace specula
