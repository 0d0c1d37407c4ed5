#pragma once

#include "mrroc/message.hpp"
#include "mrroc/types.hpp"

/// What a running task may configure of a camera (`Sensor::configure`): what it looks for, where, and how long its
/// hardware exposes. Each holds until the next one of its type; the deployment's keys hold until then.
namespace mrroc {

/// An ArUco marker of the dictionary, its black square with sides of `size` m. Dictionary empty: that of the
/// deployment. Refused when the dictionary is unknown or has no such marker.
struct LookFor {
  int marker = 0;
  double size = 0.05;
  FixedText<kNameLength> dictionary = {};
};
MRROC_MESSAGE(LookFor, marker, size, dictionary)

/// A blob of a colour on a plane, given in the deployment's `frame`: the keys of camera.toml. Hue from, to in degrees,
/// from above to goes through 0 (red); saturation and value from, to in 0..1; least area in px; point (m) and normal of
/// the plane. Refused when a fixed camera does not see the plane.
struct LookForColour {
  Eigen::Vector2d hue{340, 20};
  Eigen::Vector2d saturation{0.5, 1};
  Eigen::Vector2d value{0.2, 1};
  double min_area = 30;
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  Eigen::Vector3d plane_normal = Eigen::Vector3d::UnitZ();
};
MRROC_MESSAGE(LookForColour, hue, saturation, value, min_area, plane, plane_normal)

/// The part of the picture that is searched: its upper left pixel (u, v) and its size, px, at least 16 by 16 and within
/// the picture; width and height 0: the whole picture. `Camera::pixel` stays that of the whole picture. A smaller part
/// is searched faster.
struct Region {
  int u = 0;
  int v = 0;
  int width = 0;
  int height = 0;
};
MRROC_MESSAGE(Region, u, v, width, height)

/// How long each picture is exposed, s, without the device's own control of it: cameras of hardware only, others refuse
/// it. The next reading's picture was begun after the change.
struct Exposure {
  double seconds = 0.01;
};
MRROC_MESSAGE(Exposure, seconds)

}  // namespace mrroc
