#include "cooperative_transfer/report/variant.hpp"

#include <array>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include "cooperative_transfer/transfer_path.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::transfer {

namespace {

/// Of a file of the task.
std::string text_of(const std::string& name) {
  const std::string path = MRROC_SOURCE_DIR "/tasks/cooperative_transfer/" + name;
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::runtime_error("the task's files have no " + what);
  text.replace(at, what.size(), by);
}

std::string attributes(const Pose& pose) {
  const Eigen::Quaterniond q(pose.linear());
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), "pos=\"%.9g %.9g %.9g\" quat=\"%.9g %.9g %.9g %.9g\"", pose.translation().x(),
                pose.translation().y(), pose.translation().z(), q.w(), q.x(), q.y(), q.z());
  return text.data();
}

}  // namespace

Pose Variant::error_of(unsigned seed) {
  if (seed == 0) return Pose::Identity();
  std::mt19937 random{seed};
  const auto number = [&random] { return static_cast<double>(random()) / 2147483648.0 - 1; };  // -1 to 1
  const double x = number(), y = number(), z = number(), roll = number(), pitch = number(), yaw = number();
  constexpr double kTurn = 0.5 * 0.017453292519943295;
  return pose_from_rpy(0.001 * Eigen::Vector3d(x, y, z), kTurn * Eigen::Vector3d(roll, pitch, yaw));
}

std::filesystem::path write_variant(const Variant& variant, const std::filesystem::path& folder) {
  const std::string place = attributes(way::lift().front() * variant.error);
  std::string scene = text_of("cooperative_transfer.xml");
  replace(scene, "<body name=\"from\" pos=\"0.75 0 0.50\"", "<body name=\"from\" " + place);
  replace(scene, "<body name=\"bar\" pos=\"0.75 0 0.50\"", "<body name=\"bar\" " + place);
  replace(scene, "mass=\"1.5\"", "mass=\"" + std::to_string(variant.mass) + "\"");
  std::ofstream(folder / "cooperative_transfer.xml") << scene;
  std::ofstream(folder / "cooperative_transfer.toml") << text_of("cooperative_transfer.toml");
  return folder / "cooperative_transfer.toml";
}

}  // namespace mrroc::transfer
