#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/deployment.hpp"
#include "sim/scene/driven_joints.hpp"
#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::cli {

/// The poses of all bodies of a deployment's world, from the run's events: robots by their joints through MuJoCo's
/// forward kinematics, whatever their hardware, everything else by the state of the simulated world. One thread.
class WorldView {
 public:
  /// Throws config::ConfigurationError as `compose`.
  explicit WorldView(const config::Deployment& deployment);

  const mjModel& model() const noexcept { return *model_; }
  /// Takes the event "robot" or "world"; others are ignored. Numbers of another world are ignored.
  void take(std::string_view event);
  /// The event "poses" of all that has been taken: `bodies`, and `desired` of the robots' desired joints, position
  /// (m) and quaternion (x y z w) of each body in the world.
  std::string poses();
  /// Whether something new has been taken since the last `poses`.
  bool changed() const noexcept { return changed_; }

 private:
  /// Numbers of the simulated world that belong at another place of the view.
  struct Moved {
    int from, to, count;
    bool of_robot;
  };
  struct ViewedRobot {
    sim::DrivenJoints joints;
    bool in_world;  ///< of the simulation
  };
  void take_world(const world::WorldSnapshot& world);

  sim::Model model_;
  sim::Data actual_, desired_;
  std::map<std::string, ViewedRobot, std::less<>> robots_;
  std::vector<Moved> positions_;                ///< of joints
  std::vector<std::pair<int, int>> mocaps_;     ///< of bodies
  int world_positions_ = 0, world_mocaps_ = 0;  ///< of the simulated world
  bool simulated_ = false;                      ///< its states arrive
  Tick tick_ = 0;
  bool changed_ = false;
};

}  // namespace mrroc::cli
