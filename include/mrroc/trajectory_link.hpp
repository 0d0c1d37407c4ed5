#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

enum class TrajectoryOrder : std::uint8_t {
  follow = 0,  ///< `numbers` is a part of a trajectory, which begins when all parts have come
  cancel = 1   ///< the robot comes to rest on the trajectory that it follows, and that one ends
};

/// A part of a JointTrajectory on its way to the task that yields the robot.
struct TrajectoryPart {
  static constexpr std::size_t kNumbers = 512;

  FixedText<kNameLength> robot;
  TrajectoryOrder order = TrajectoryOrder::follow;
  std::uint64_t trajectory = 0;  ///< its number in the run, from 1
  std::uint32_t size = 0;        ///< numbers of the whole trajectory
  std::uint32_t begin = 0;       ///< number of the first one here
  std::uint16_t count = 0;
  std::array<double, kNumbers> numbers{};
};

enum class TrajectoryState : std::uint8_t {
  yielded = 0,         ///< no trajectory: from now on the robot follows trajectories
  withdrawn = 1,       ///< no trajectory: from now on it does not
  begun = 2,           ///< the robot follows it
  arrived = 3,         ///< the robot rests at its end, within the tolerance
  refused = 4,         ///< it is wrong, or too fast, or begins elsewhere; nothing has moved for it
  path_tolerance = 5,  ///< the robot was too far from it, and comes to rest
  goal_tolerance = 6,  ///< the robot rests too far from its end
  cancelled = 7,       ///< by `cancel`, or replaced by another one
  taken_back = 8       ///< the task's Move has ended
};

/// What has become of a trajectory, or whether the robot follows any.
struct TrajectoryReport {
  FixedText<kNameLength> robot;
  std::uint64_t trajectory = 0;
  TrajectoryState state = TrajectoryState::yielded;
  FixedText<127> text;  ///< what was wrong and what was expected
  Tick tick = 0;
};

/// The way on which trajectories of other programs come to a task, and reports back; a process's link, a test's fake.
/// Task's thread; neither waits nor allocates.
class TrajectoryLink {
 public:
  virtual ~TrajectoryLink() = default;
  /// The next part for this robot; false when none has come.
  virtual bool take(const FixedText<kNameLength>& robot, TrajectoryPart& part) = 0;
  virtual void report(const TrajectoryReport& report) = 0;
};

}  // namespace mrroc
