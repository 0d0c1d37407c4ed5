#include "geometry/pose_path.hpp"

#include <algorithm>

#include "geometry/near_places.hpp"
#include "geometry/rigid_motion.hpp"
#include "geometry/rotation_rates.hpp"

namespace mrroc {

Eigen::Vector3d turn_between(const Pose& from, const Pose& to) noexcept {
  return rotation_vector(to.linear() * from.linear().transpose());
}

PosePiece::PosePiece(const PathPose& from, const PathPose& to, double length)
    : from_(from), to_(to), coordinates_(plan(from, to, length)) {}

PosePiece::Coordinates PosePiece::plan(const PathPose& from, const PathPose& to, double length) {
  const Eigen::Vector3d turn = turn_between(from.pose, to.pose);
  const Turning end = vector_rates_of(turn, {to.first.tail<3>(), to.second.tail<3>()});
  Coordinates::State start{Twist::Zero(), from.first, from.second}, stop{Twist::Zero(), to.first, to.second};
  start.value.head<3>() = from.pose.translation();
  stop.value << to.pose.translation(), turn;
  stop.first.tail<3>() = end.velocity;
  stop.second.tail<3>() = end.rate;
  return Coordinates(start, stop, length);
}

PathPose PosePiece::at(double s) const noexcept {
  if (s <= 0) return from_;
  if (s >= coordinates_.length()) return to_;
  const Coordinates::State state = coordinates_.at(s);
  const Eigen::Vector3d vector = state.value.tail<3>();
  const Turning turning = turning_of(vector, state.first.tail<3>(), state.second.tail<3>());
  PathPose there;
  there.pose.translation() = state.value.head<3>();
  there.pose.linear() = exp_rotation(vector) * from_.pose.linear();
  there.first << state.first.head<3>(), turning.velocity;
  there.second << state.second.head<3>(), turning.rate;
  return there;
}

void PiecedPath::add(const PathPose& from, const PathPose& to, double length) {
  pieces_.emplace_back(from, to, length);
  breaks_.push_back(breaks_.back() + length);
}

PathPose PiecedPath::at(std::size_t piece, double s) const noexcept {
  // the end itself, without rounding errors of the difference
  return s >= breaks_[piece + 1] ? pieces_[piece].at(breaks_[piece + 1]) : pieces_[piece].at(s - breaks_[piece]);
}

LineEnds line_between(const Pose& from, const Pose& to, double length) noexcept {
  Twist pace;
  pace << (to.translation() - from.translation()) / length, turn_between(from, to) / length;
  return {{from, pace, Twist::Zero()}, {to, pace, Twist::Zero()}};
}

bool are_near(const Pose& a, const Pose& b) noexcept {
  return (a.translation() - b.translation()).norm() < kSamePlace && turn_between(a, b).norm() < kSamePlace;
}

double full_speed_time(const Pose& from, const Pose& to, double speed, double angular_speed) noexcept {
  return std::max((to.translation() - from.translation()).norm() / speed,
                  turn_between(from, to).norm() / angular_speed);
}

}  // namespace mrroc
