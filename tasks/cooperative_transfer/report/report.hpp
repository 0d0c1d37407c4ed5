#pragma once

#include <filesystem>
#include <vector>

#include "cooperative_transfer/transfer_path.hpp"
#include "mrroc/types.hpp"

namespace mrroc::transfer {

/// The bar at one step of the task cooperative_transfer.
struct ReportStep {
  double time = 0;  ///< s, since the bar was lifted
  Tick tick = 0;
  double way = 0, turn = 0;                            ///< m, rad: off its path, as it was gripped
  double way_off = 0, turn_off = 0;                    ///< the same with the error of the grasp
  Eigen::Vector3d internal = Eigen::Vector3d::Zero();  ///< N, in the bar's axes: force of the right arm on the left one
  Eigen::Vector3d internal_torque = Eigen::Vector3d::Zero();  ///< N m, half of the difference of the torques
  double weight = 0;                                          ///< N, borne by both arms
};

/// The result of a run of the task, read from its recording: the bar's pose by the tracker against the path at the same
/// tick, and the wrenches in both wrists. Internal force: half of the difference of the forces of the bar on the arms
/// (Uchiyama and Dauchez), from the recording's raw sensor values, all steps from the lift until it is put down.
struct Report {
  std::vector<ReportStep> steps;
  std::uint64_t skew = 0;  ///< ticks, worst of all Moves
  bool complete = false;   ///< lifted, carried and lowered

  double worst_way() const;   ///< m
  double worst_turn() const;  ///< rad
  double worst_way_off() const;
  double worst_turn_off() const;
  double worst_internal() const;         ///< N
  double rms_internal() const;           ///< N
  double worst_internal_torque() const;  ///< N m
};

/// Throws std::runtime_error when the file is not a recording of the task.
Report read_report(const std::filesystem::path& trace, const Arms& arms = kSixAxes);

}  // namespace mrroc::transfer
