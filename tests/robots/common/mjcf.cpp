#include "robots/common/mjcf.hpp"

#include <array>
#include <stdexcept>

namespace mrroc {
namespace {

mjModel* load(const std::filesystem::path& file) {
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  if (model == nullptr) throw std::runtime_error(error.data());
  return model;
}

}  // namespace

Mjcf::Mjcf(const std::filesystem::path& file)
    : model(load(file), mj_deleteModel), data(mj_makeData(model.get()), mj_deleteData) {}

void Mjcf::set_joints(const JointVector& joints) {
  for (int i = 0; i < model->nq; ++i) data->qpos[i] = joints[i];
}

Pose Mjcf::site(const char* name) const {
  const int id = mj_name2id(model.get(), mjOBJ_SITE, name);
  if (id < 0) throw std::runtime_error(std::string("no site ") + name);
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(data->site_xpos + 3 * id);
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data->site_xmat + 9 * id);
  return pose;
}

JointMatrix Mjcf::mass_matrix() const {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> full(model->nv, model->nv);
  mj_fullM(model.get(), full.data(), data->qM);
  return full;
}

}  // namespace mrroc
