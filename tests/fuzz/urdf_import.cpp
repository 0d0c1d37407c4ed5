// A URDF of which `mrroc robot add` makes a robot type, up to the files that it writes: the reader of meshes and MuJoCo
// are not tested.
#include <algorithm>

#include "cli/robot/import/robot_mjcf.hpp"
#include "cli/robot/import/robot_toml.hpp"
#include "cli/robot/import/urdf_copy.hpp"
#include "config/table.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "sim/scene/mjcf_part.hpp"

namespace {

using namespace mrroc;

bool has_mesh(const cli::UrdfBodies& bodies) {
  const auto is_mesh = [](const cli::UrdfShape& shape) { return shape.kind == cli::UrdfShape::Kind::mesh; };
  return std::any_of(bodies.bodies.begin(), bodies.bodies.end(), [&](const cli::UrdfBody& body) {
    return std::any_of(body.visuals.begin(), body.visuals.end(), is_mesh) ||
           std::any_of(body.collisions.begin(), body.collisions.end(), is_mesh);
  });
}

void import(const std::filesystem::path& file) {
  static const fuzz::MemoryFile parameters, mjcf;
  cli::Findings findings(file);
  const edp::Urdf urdf = edp::Urdf::load(file, edp::Urdf::Limits::optional);
  const cli::UrdfBodies bodies = cli::read_urdf_bodies(file, findings);
  const cli::UrdfArm arm = cli::arm_of(urdf, "", "");
  const std::vector<cli::AxisLimits> axes = cli::limits_of_axes(urdf, arm, {}, true, findings);
  const JointVector home = JointVector::Zero(std::ssize(axes));
  cli::urdf_copy(file, {{"a.stl", "a"}});
  if (has_mesh(bodies)) return;
  cli::MeshPaths paths(file, findings);
  cli::MeshStore meshes("meshes");
  cli::LinkShapes shapes(file, 1, paths, meshes, findings);
  const cli::RobotMjcf made(urdf, bodies, arm, axes, shapes, findings);
  const sim::Text text = sim::write(made.mjcf("arm", {}));
  const auto read = [&] { sim::read_part(mjcf.write(text.text), "arm/"); };
  fuzz::refuses<config::ConfigurationError>(read);  // numbers that MuJoCo does not take
  fuzz::require(!findings.text().empty() || axes.empty(), "limits were guessed");
  const bool torques = std::all_of(axes.begin(), axes.end(), [](const auto& axis) { return axis.torque.has_value(); });
  const std::vector<cli::AxisDrive> drives(axes.size(), {.inertia_min = 0.5, .inertia_max = 1, .rotor = 0.1});
  const std::string toml = cli::robot_toml("arm", "arm.urdf", arm, axes,
                                           torques ? cli::DriveKind::torque : cli::DriveKind::itself, drives, home);
  const config::Table table = config::Table::parse("arm.toml", toml);
  const config::Table joints = table.table("chain").table("joints");
  fuzz::require(table.tables("axes").size() == axes.size(), "the file has every axis");
  for (const cli::AxisLimits& axis : axes) fuzz::require(joints.has(axis.name), "the file has every joint");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  const auto urdf = file.write(fuzz::text_of(data, size));
  fuzz::refuses<mrroc::config::ConfigurationError>([&] { import(urdf); });
  return 0;
}
