#pragma once

#include "config/deployment.hpp"
#include "mrroc/types.hpp"

namespace mrroc::vsp {

/// The frame F in which a camera's reading is, its key `frame`:
///
///     ""        base frame of the robot that carries the camera; the world's when none does
///     "camera"  the camera's own
///     "world"
///     NAME      base frame of robot NAME
///
/// With M the camera's mount, its pose in the flange frame or in the world, its pose in F is
///
///     carried by robot R    F_R * flange * M       F_R: of R's base frame in F
///     fixed in the world    F_W * M                F_W: of the world in F
///     frame = "camera"      identity
class ReadingFrame {
 public:
  /// The world's frame of a camera at its origin.
  ReadingFrame() = default;
  /// `mount` may be identity when nothing depends on it. Throws SystemError(configuration): no such robot, or one that
  /// another robot carries, whose base moves.
  ReadingFrame(const config::Deployment& deployment, const config::SensorEntry& entry, const Pose& mount);

  bool is_camera() const noexcept { return is_camera_; }
  /// Whether the camera's pose depends on its robot's pose.
  bool moves() const noexcept { return moves_; }
  /// Pose of the camera in F; `flange`: in its robot's base frame, ignored unless the camera moves.
  Pose of_camera(const Pose& flange) const noexcept { return moves_ ? origin_ * flange * mount_ : origin_ * mount_; }

 private:
  bool is_camera_ = false;
  bool moves_ = false;
  Pose origin_ = Pose::Identity();  ///< F_R or F_W
  Pose mount_ = Pose::Identity();
};

}  // namespace mrroc::vsp
