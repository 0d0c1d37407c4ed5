#pragma once

#include <array>
#include <cstdint>

#include "edp/safety/set_point_history.hpp"
#include "edp/servo/snapshot.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Watches whether the robot moves as it is instructed to, sooner than the following error does:
///
/// - a joint faster than kOverspeed times its velocity limit, over kReadings readings, has run away: its drive no
/// longer obeys; so has one that will be as fast at the next reading if it continues to gain speed, even if kTremble
/// increments of that are the encoder's (not one that homes on its own: drives may come to their speed within a tick);
/// - a shaft that reads the very same position while the set-point that its drive had continues by `stuck_max` is
/// jammed, or its encoder has died and the regulator will push it faster and faster;
/// - so is one that reads the very same position while its current has changed by what brings the free drive, its rotor
/// and its friction, to a speed at which a joint is faster than kPushed times its velocity limit. The current is the
/// one that the drive was given, or, of drives that regulate on their own, the measured one.
///
/// With drives that follow the current the set-point need not move for that: the servo's regulator adds up the part of
/// an increment by which a dead encoder differs from it. A drive that regulates on its own holds a resting set-point
/// with the current that load, friction and its own resolution require, and monitors its own encoder: its current
/// is judged only while the set-point moves, and has moved by more than kTremble increments.
///
/// The servo's thread; allocates nothing, never throws.
class MotionWatch {
 public:
  static constexpr double kOverspeed = 1.15;
  /// A single difference varies by an increment of the encoder and by the regulator's reaction.
  static constexpr std::size_t kReadings = 4;
  static constexpr double kTremble = 4;
  /// A wrist that holds one end of a bar, whose other end is also held, reaches 0.9 at rest.
  static constexpr double kPushed = 1.3;

  /// `period` in s.
  explicit MotionWatch(double period) noexcept : period_(period) {}

  /// The drives have been switched on, or the positions of joints and shafts have a new origin.
  void reset() noexcept { readings_ = 0; }
  struct Seen {
    const JointVector& joints;          ///< as they were read, rad or m
    const JointVector& velocity;        ///< of the joints, from the last two readings, rad/s or m/s
    const JointVector& motors;          ///< shafts as they were read, rad
    const JointVector& desired_motors;  ///< their set-points of the tick before
    const JointVector& current;         ///< A, positive along the shafts' positions: given last, else measured
    bool given = true;                  ///< `current` was given to drives that follow it; false: measured
  };
  /// When a reading was taken: at `time`, ticks, or up to `late` servo periods after it. Drives on a bus measure when
  /// they are asked or keep time on their own, so a servo that wakes late does not know which. In doubt a motion is
  /// slow.
  struct Taken {
    double time = 0;
    double late = 0;
    std::uint64_t unseen = 0;  ///< the drives had not received the set-points of so many ticks before it
  };
  /// Once per servo tick. The first axis that is too fast, else one that is stuck (`moves`: it is commanded, not
  /// stopping); code none: all is well. `homing`: the axis whose drive homes on its own, -1: none.
  Fault check(const RobotModel& model, const Seen& seen, Taken taken, bool moves, int homing) noexcept;

 private:
  void begin(const RobotModel& model, const Seen& seen, Taken taken) noexcept;
  Fault check_speed(const std::vector<AxisParameters>& axes, const JointVector& joints, Taken taken,
                    int homing) noexcept;
  Fault check_shafts(const RobotModel& model, const Seen& seen, std::uint64_t unseen, int homing) noexcept;
  Fault check_push(const RobotModel& model, const JointVector& joints) const noexcept;

  double period_;
  struct Reading {
    Taken taken;
    JointVector joints;
  };
  std::array<Reading, kReadings> ring_;
  std::size_t readings_ = 0;  ///< so far; number n is in place n % kReadings
  JointVector speed_;         ///< of the joints between the last two readings at most, rad/s or m/s
  JointVector tremble_;       ///< of a joint, rad or m, that kTremble increments of all shafts make
  SetPointHistory set_points_;
  JointVector motors_;         ///< where each shaft came to last
  JointVector desired_there_;  ///< its set-point when it came there
  JointVector desired_last_;   ///< the set-points that the drives had at the reading before
  JointVector current_there_;  ///< its current then
  JointVector pushed_;         ///< shaft speed that the change of its current would have brought since, rad/s
};

}  // namespace mrroc::edp
