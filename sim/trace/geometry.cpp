#include "sim/trace/geometry.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <cmath>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr float last_part_of_the_way = 0.999f;

/// One device for the whole program: a second one would start threads of its own.
RTCDevice device() {
    static const RTCDevice shared = [] {
        const RTCDevice made = rtcNewDevice("threads=1");
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

}  // namespace

struct Geometry::Held {
    RTCScene scene = rtcNewScene(device());
    ~Held() { rtcReleaseScene(scene); }
};

Geometry::Geometry(const std::vector<Mesh>& meshes) : held_(std::make_unique<Held>()) {
    rtcSetSceneFlags(held_->scene, RTC_SCENE_FLAG_ROBUST);
    for (const Mesh& mesh : meshes) {
        check(mesh);
        attach(held_->scene, mesh);
    }
    rtcCommitScene(held_->scene);
    if (const RTCError error = rtcGetDeviceError(device()); error != RTC_ERROR_NONE)
        throw SystemError(
            format("Embree could not take the scene (error {})", static_cast<int>(error)));
}

Geometry::~Geometry() = default;
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;

void Geometry::shadow(const Vector3& from, std::span<const Vector3> to,
                      std::span<char> clear) const {
    for (std::size_t first = 0; first < to.size(); first += 16) {
        const std::size_t n = std::min<std::size_t>(16, to.size() - first);
        alignas(64) RTCRay16 rays{};
        alignas(64) int valid[16] = {};
        for (std::size_t i = 0; i < n; ++i) {
            const Vector3 way = to[first + i] - from;
            if (!way.allFinite()) continue;  // Debian's Embree aborts on a ray that is not finite
            valid[i] = -1;
            rays.org_x[i] = static_cast<float>(from.x());
            rays.org_y[i] = static_cast<float>(from.y());
            rays.org_z[i] = static_cast<float>(from.z());
            rays.dir_x[i] = static_cast<float>(way.x());
            rays.dir_y[i] = static_cast<float>(way.y());
            rays.dir_z[i] = static_cast<float>(way.z());
            rays.tfar[i] = last_part_of_the_way;
            rays.mask[i] = ~0u;
        }
        occluded(held_->scene, valid, rays);
        for (std::size_t i = 0; i < n; ++i)
            if (rays.tfar[i] < 0.0f) clear[first + i] = 0;  // Embree's mark of a hit
    }
}

}  // namespace specula
