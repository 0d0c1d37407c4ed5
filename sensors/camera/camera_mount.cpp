#include "sensors/camera/camera_mount.hpp"

#include <numbers>
#include <optional>

#include "sensors/camera/keys.hpp"
#include "sim/rendering/camera.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

Pose pose_of(const double* position, const double* quaternion) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d{position};
  pose.linear() =
      Eigen::Quaterniond{quaternion[0], quaternion[1], quaternion[2], quaternion[3]}.normalized().toRotationMatrix();
  return pose;
}

/// Of a body in the world, in the model's own posture.
Pose pose_of_body(const mjModel& model, int body) {
  Pose pose = Pose::Identity();
  for (; body != 0; body = model.body_parentid[body]) {
    pose = pose_of(model.body_pos + 3 * body, model.body_quat + 4 * body) * pose;
  }
  return pose;
}

/// A frame fixed to a body.
struct Attached {
  int body = 0;
  Pose in_body = Pose::Identity();
};

/// The flange of the sensor's robot, or the world.
std::optional<Attached> carrier_of(const mjModel& model, const config::SensorEntry& entry) {
  if (entry.robot.empty()) return Attached{};
  const std::string name = entry.robot + "/flange";
  if (const int body = mj_name2id(&model, mjOBJ_BODY, name.c_str()); body >= 0) return Attached{body};
  if (const int site = mj_name2id(&model, mjOBJ_SITE, name.c_str()); site >= 0) {
    return Attached{model.site_bodyid[site], pose_of(model.site_pos + 3 * site, model.site_quat + 4 * site)};
  }
  return std::nullopt;
}

std::optional<int> mjcf_camera(const mjModel& model, const config::SensorEntry& entry) {
  const std::string& asked = text(entry, "camera");
  std::vector<std::string> names{asked};
  if (asked.empty()) names = {entry.name};
  if (asked.empty() && !entry.robot.empty()) names.insert(names.begin(), entry.robot + "/" + entry.name);
  for (const std::string& name : names) {
    if (const int camera = mj_name2id(&model, mjOBJ_CAMERA, name.c_str()); camera >= 0) return camera;
  }
  const std::vector<std::string> known = sim::camera_names(model);
  const std::string those = known.empty() ? "none: the world has no camera" : "one of " + listed(known);
  if (!asked.empty()) refuse(entry, "camera", "no camera \"" + asked + "\"", those);
  if (mount_pose(entry)) return std::nullopt;
  refuse(entry, "camera", "no camera \"" + listed(names) + "\"", those + ", or the keys 'position' and 'rotation'");
}

CameraMount posed_camera(const mjModel& model, const config::SensorEntry& entry) {
  const auto carrier = carrier_of(model, entry);
  if (!carrier) {
    refuse(entry, "position", "robot " + entry.robot + " has no body or site \"flange\" in its MJCF",
           "a camera in its MJCF and frame = 'camera'");
  }
  const Pose mount = *mount_pose(entry);
  return {carrier->body, carrier->in_body * mount, mount};
}

}  // namespace

CameraMount find_camera(const mjModel& model, const config::SensorEntry& entry) {
  const auto camera = mjcf_camera(model, entry);
  if (!camera) return posed_camera(model, entry);
  const std::string name = model.names + model.name_camadr[*camera];
  if (mount_pose(entry)) refuse(entry, "position", "the MJCF's camera \"" + name + "\" has its own pose", "none");
  if (model.cam_mode[*camera] != mjCAMLIGHT_FIXED)
    refuse(entry, "camera", "\"" + name + "\" tracks a body", "mode 'fixed'");
  CameraMount found;
  found.name = name;
  found.body = model.cam_bodyid[*camera];
  found.field_of_view = model.cam_fovy[*camera] * std::numbers::pi / 180;
  found.in_body = pose_of(model.cam_pos + 3 * *camera, model.cam_quat + 4 * *camera);
  found.in_body.linear() *= Eigen::Vector3d(1, -1, -1).asDiagonal();  // MuJoCo's camera points along its -z, y is up
  const auto carrier = carrier_of(model, entry);
  if (!carrier) {
    if (text(entry, "frame") == "camera") return found;
    refuse(entry, "frame", "robot " + entry.robot + " has no body or site \"flange\" in its MJCF", "frame = 'camera'");
  }
  if (model.body_weldid[found.body] != model.body_weldid[carrier->body]) {
    refuse(entry, "camera",
           "\"" + name + "\" is fixed to body \"" + std::string(model.names + model.name_bodyadr[found.body]) + "\"",
           entry.robot.empty() ? "one that is fixed in the world, or the key 'robot' beside it"
                               : "one fixed to the flange of robot " + entry.robot);
  }
  found.mount = (pose_of_body(model, carrier->body) * carrier->in_body).inverse() * pose_of_body(model, found.body) *
                found.in_body;
  return found;
}

}  // namespace mrroc::vsp
