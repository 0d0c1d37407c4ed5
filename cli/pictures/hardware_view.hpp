#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "config/deployment.hpp"
#include "mrroc/types.hpp"
#include "process/picture_memory.hpp"
#include "sensors/camera/intrinsics.hpp"
#include "sim/rendering/picture.hpp"

namespace mrroc::cli {

/// A camera of hardware as programs beside the run see it: the picture of its newest reading, in memory of the run.
/// One thread.
class HardwareView {
 public:
  /// `file`: of the memory, as the run's status names it. Throws SystemError when it cannot be opened.
  HardwareView(const config::SensorEntry& camera, const std::filesystem::path& file);

  /// From the deployment's keys, with the calibrated focal length; focal lengths of 0: it has no such keys.
  const vsp::Intrinsics& intrinsics() const noexcept { return intrinsics_; }
  /// Whether there is another picture than the one that `load` has returned.
  bool has_new() const noexcept { return memory_.sequence() != loaded_; }
  /// Copies the newest picture and returns its tick; nothing: the camera has made no reading yet.
  std::optional<Tick> load(sim::Picture& picture);

 private:
  vsp::Intrinsics intrinsics_;
  process::PictureMemory memory_;
  std::uint64_t loaded_ = 0;
};

}  // namespace mrroc::cli
