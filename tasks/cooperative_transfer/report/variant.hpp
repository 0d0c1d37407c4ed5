#pragma once

#include <filesystem>

#include "mrroc/types.hpp"

namespace mrroc::transfer {

/// The deployment of the task cooperative_transfer with another bar at another pose than the task assumes.
struct Variant {
  double mass = 1.5;  ///< kg
  Pose error =
      Pose::Identity();  ///< of the bar and the stands that it lies on: its pose is way::lift().front() * error

  /// Each coordinate off by up to 1 mm, each turn by up to 0.5 degrees, uniformly; 0: no error.
  static Pose error_of(unsigned seed);
};

/// Writes scene and deployment into `folder`, which exists; returns the deployment's file.
std::filesystem::path write_variant(const Variant& variant, const std::filesystem::path& folder);

}  // namespace mrroc::transfer
