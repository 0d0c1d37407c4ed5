#pragma once

#include <string>
#include <vector>

#include "mrroc/types.hpp"
#include "sim/scene/model.hpp"

namespace mrroc::sim {

/// A body of the scene that is free (its joint is a `freejoint`), with all that hangs on it, such as a part that lies
/// in a magazine until it is put somewhere. The simulation's thread.
class FreeBody {
 public:
  /// Throws config::ConfigurationError at `key` when the scene has no such body, or it is not free.
  FreeBody(const mjModel& model, const std::string& name, const std::string& key);

  /// From now on it has no weight and touches nothing: at rest it stays where it is.
  void hold(mjModel& model, mjData& data);
  /// Puts its frame at `pose` in the world, at rest, and gives it back weight and touch. Allocates nothing. Positions
  /// and velocities of the world have to be evaluated again.
  void put(mjModel& model, mjData& data, const Pose& pose) const;

 private:
  struct Touch {
    int geom, type, affinity;
  };
  int body_;
  std::vector<Touch> touches_;  ///< of its geoms, while it is held
};

}  // namespace mrroc::sim
