#include "sensors/camera/reading_frame.hpp"

#include <algorithm>

#include "sensors/camera/keys.hpp"
#include "vsp/parameters.hpp"

namespace mrroc::vsp {

namespace {

/// Pose of a robot's base in the world.
Pose base_of(const config::Deployment& deployment, const config::SensorEntry& entry, const std::string& name) {
  std::vector<std::string> known{"world", "camera"};
  for (const config::RobotEntry& robot : deployment.robots) {
    known.push_back(robot.name);
    if (robot.name != name) continue;
    if (!robot.mount.empty()) {
      refuse(entry, "frame", "robot " + name + " is carried by " + robot.mount + ": its base moves",
             "a robot that is fixed in the world, or the camera's own");
    }
    return robot.known_base();
  }
  refuse(entry, "frame", "\"" + name + "\"", "one of " + listed(known));
}

}  // namespace

ReadingFrame::ReadingFrame(const config::Deployment& deployment, const config::SensorEntry& entry, const Pose& mount) {
  const std::string& frame = text(entry, "frame");
  is_camera_ = frame == "camera";
  if (is_camera_) return;
  mount_ = mount;
  moves_ = !entry.robot.empty();
  const std::string& carrier = entry.robot;  // "": the world
  const std::string& wanted = frame == "world" ? std::string{} : frame.empty() ? carrier : frame;
  if (wanted == carrier) return;
  const Pose from = carrier.empty() ? Pose::Identity() : base_of(deployment, entry, carrier);
  const Pose to = wanted.empty() ? Pose::Identity() : base_of(deployment, entry, wanted);
  origin_ = to.inverse() * from;
}

}  // namespace mrroc::vsp
