#include "scenes/shape.hpp"

#include "scenes/mesh_checks.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

const Range possible_size = Range::inside(0.0, 10.0);

double metres_of(const std::string& unit) {
    return unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : unit == "in" ? 0.0254 : 1.0;
}

void set_mesh(Sample& sample, Mesh mesh) {
    const Vector3 size = box_around(mesh).size();
    sample.face = {.size_x_m = size.x(), .size_y_m = size.y()};
    sample.mesh = std::make_shared<const Mesh>(std::move(mesh));
}

bool read_mesh_shape(Section& section, Sample& sample, std::vector<std::string>& warnings) {
    const std::filesystem::path named = section.text("file");
    const std::string unit = section.choice("unit", {"mm", "cm", "m", "in"});
    const auto file = std::filesystem::path(section.file()).parent_path() / named;
    if (!std::filesystem::exists(file))
        section.fail("file", "no such file beside this one", "give a path relative to this file");
    MeshFile read = read_mesh(file, metres_of(unit));
    warnings.insert(warnings.end(), read.warnings.begin(), read.warnings.end());
    set_mesh(sample, std::move(read.mesh));
    return read.is_watertight;
}

}  // namespace

bool read_shape(Section& section, Sample& sample, std::vector<std::string>& warnings) {
    const std::string shape = section.choice("shape", {"plate", "box", "mesh"}, "plate");
    if (shape == "mesh") return read_mesh_shape(section, sample, warnings);
    const bool is_box = shape == "box";
    const auto size = section.quantities("size", Unit::length, is_box ? 3 : 2, possible_size);
    if (is_box) {
        set_mesh(sample, box_mesh({size[0], size[1], size[2]}));
        return true;
    }
    sample.face = {.size_x_m = size[0],
                   .size_y_m = size[1],
                   .bow_m = section.quantity("bow", Unit::length, Range::between(-0.05, 0.05), 0.)};
    return false;
}

Rotation read_rotation(Section& section) {
    if (!section.has_quantity("rotation", Unit::angle)) return Rotation::Identity();
    const auto turn =
        section.quantities("rotation", Unit::angle, 3, Range::between(-two_pi, two_pi));
    return (Eigen::AngleAxisd(turn[2], Vector3::UnitZ()) *
            Eigen::AngleAxisd(turn[1], Vector3::UnitY()) *
            Eigen::AngleAxisd(turn[0], Vector3::UnitX()))
        .toRotationMatrix();
}

}  // namespace specula
