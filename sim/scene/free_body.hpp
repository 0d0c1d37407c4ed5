#pragma once

#include <string>
#include <vector>

#include "mrroc/types.hpp"
#include "sim/scene/model.hpp"

namespace mrroc::sim {

/// A body of the scene that is free (its joint is a `freejoint`), with all its children, such as a part that lies
/// in a magazine until it is put somewhere. The simulation's thread.
class FreeBody {
 public:
  /// Throws config::ConfigurationError at `key` when the scene has no such body, or it is not free.
  FreeBody(const mjModel& model, const std::string& name, const std::string& key);

  /// Removes its weight and its contacts: at rest it stays where it is.
  void hold(mjModel& model, mjData& data);
  /// Puts its frame at `pose` in the world, at rest, and restores weight and contacts. Allocates nothing. The caller
  /// must evaluate positions and velocities of the world again.
  void put(mjModel& model, mjData& data, const Pose& pose) const;

 private:
  struct Touch {
    int geom, type, affinity;
  };
  int body_;
  std::vector<Touch> touches_;  ///< of its geoms, while it is held
};

}  // namespace mrroc::sim
