#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "config/text/message_text.hpp"
#include "mrroc/types.hpp"
#include "sim/scene/xml.hpp"

namespace mrroc::cli {

using Attributes = std::vector<std::pair<std::string, std::string>>;

inline sim::Element mjcf_element(std::string name, Attributes attributes, std::vector<sim::Element> children = {}) {
  return {std::move(name), std::move(attributes), std::move(children), {}};
}

/// Numbers with blanks between, each the shortest that reads back as the same.
template <class Vector>
std::string mjcf_numbers(const Vector& vector) {
  std::string text;
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    if (i > 0) text += ' ';
    text += config::number_text(vector[i]);
  }
  return text;
}

/// `pos` and `quat` of a pose, without those of the identity.
inline void add_mjcf_pose(Attributes& attributes, const Pose& pose) {
  if (!pose.translation().isZero(0)) attributes.emplace_back("pos", mjcf_numbers(Eigen::Vector3d(pose.translation())));
  if (pose.linear() == Eigen::Matrix3d::Identity()) return;
  const Eigen::Quaterniond q(pose.linear());
  attributes.emplace_back("quat", mjcf_numbers(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())));
}

}  // namespace mrroc::cli
