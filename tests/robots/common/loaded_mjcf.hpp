#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "mrroc/types.hpp"

namespace mrroc {

/// A robot's own MJCF and its state. Throws std::runtime_error with MuJoCo's message when the file does not load.
struct LoadedMjcf {
  explicit LoadedMjcf(const std::filesystem::path& file)
      : model(load(file), mj_deleteModel), data(mj_makeData(model.get()), mj_deleteData) {}

  void set_joints(const JointVector& joints) {
    for (int i = 0; i < model->nq; ++i) data->qpos[i] = joints[i];
  }
  int id(mjtObj type, const std::string& name) const {
    const int found = mj_name2id(model.get(), type, name.c_str());
    if (found < 0) throw std::runtime_error("no " + name);
    return found;
  }
  /// After mj_kinematics or mj_forward.
  Pose site(const std::string& name) const {
    const int site = id(mjOBJ_SITE, name);
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Map<const Eigen::Vector3d>(data->site_xpos + 3 * site);
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data->site_xmat + 9 * site);
    return pose;
  }

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data;

 private:
  static mjModel* load(const std::filesystem::path& file) {
    std::array<char, 1000> error{};
    mjModel* model = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
    if (model == nullptr) throw std::runtime_error(error.data());
    return model;
  }
};

}  // namespace mrroc
