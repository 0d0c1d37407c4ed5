#pragma once

#include <filesystem>
#include <fstream>

#include "mrroc/types.hpp"
#include "sim/world.hpp"

namespace mrroc::sim {

/// Records where a world's cutter has removed material, in `removed.txt` beside the world's snapshots, so that a
/// picture of one of them shows the wood of its tick. Text: "mrroc removed material 1", then a line for each tick in
/// which something was removed: tick, and the centre of the cutter's nose in the frame of the height field, m.
class RemovedMaterial {
 public:
  /// `folder`: of the snapshots. Nothing is written before the cutter removes something.
  explicit RemovedMaterial(const std::filesystem::path& folder);

  /// The world has reached `tick`. Throws SystemError (resources).
  void write(const World& world, Tick tick);

 private:
  std::filesystem::path file_;
  std::ofstream out_;
};

/// Removes from the wood of `model` what the cutter had removed until `tick`: the file beside the snapshot `state`, if
/// there is one. Throws config::ConfigurationError (no such record, or the world has no cutter).
void remove_material(mjModel& model, const std::filesystem::path& scene, const std::filesystem::path& state, Tick tick);

}  // namespace mrroc::sim
