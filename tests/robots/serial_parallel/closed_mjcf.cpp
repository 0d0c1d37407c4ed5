#include "robots/serial_parallel/closed_mjcf.hpp"

#include <Eigen/LU>
#include <stdexcept>
#include <string>

#include "robots/serial_parallel/fixture.hpp"

namespace mrroc {
namespace {

constexpr int kEquations = 6;  // two connects
constexpr int kIterations = 30;

using Matrix6 = Eigen::Matrix<double, kEquations, 6>;
using Dense = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

mjModel* load() {
  std::array<char, 1000> error{};
  const auto file = serial_parallel_source("serial_parallel.xml");
  mjModel* model = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  if (model == nullptr) throw std::runtime_error(error.data());
  return model;
}

}  // namespace

ClosedMjcf::ClosedMjcf() : model(load(), &mj_deleteModel), data(mj_makeData(model.get()), &mj_deleteData) {
  model->opt.jacobian = mjJAC_DENSE;
  const auto& axes = machine().parameters().axes;
  for (std::size_t i = 0; i < 6; ++i) driven_[i] = dof(axes[i].name.c_str());
  passive_ = {dof("swing_a"), dof("lean_a"), dof("tilt_a"), dof("tilt_b"), dof("swing_c"), dof("lean_c")};
  if (model->nv != 12 || model->nq != 12) throw std::runtime_error("the MJCF has other joints than these");
}

int ClosedMjcf::dof(const char* joint) const {
  const int id = mj_name2id(model.get(), mjOBJ_JOINT, joint);
  if (id < 0) throw std::runtime_error(std::string("no joint ") + joint);
  return model->jnt_dofadr[id];
}

void ClosedMjcf::reset() { mj_resetData(model.get(), data.get()); }

bool ClosedMjcf::close(const JointVector& joints) {
  for (std::size_t i = 0; i < 6; ++i) data->qpos[driven_[i]] = joints[static_cast<Eigen::Index>(i)];
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    mj_fwdPosition(model.get(), data.get());
    const Dense rows(data->efc_J, kEquations, model->nv);
    Matrix6 by_passive;
    for (int i = 0; i < 6; ++i) by_passive.col(i) = rows.col(passive_[static_cast<std::size_t>(i)]);
    const Eigen::Matrix<double, 6, 1> step =
        by_passive.partialPivLu().solve(Eigen::Map<const Eigen::Matrix<double, 6, 1>>(data->efc_pos));
    if (residual() < 1e-14 || step.cwiseAbs().maxCoeff() < 1e-15) return true;
    for (int i = 0; i < 6; ++i) data->qpos[passive_[static_cast<std::size_t>(i)]] -= step[i];
  }
  return residual() < 1e-13;
}

double ClosedMjcf::residual() const {
  return Eigen::Map<const Eigen::Matrix<double, kEquations, 1>>(data->efc_pos).cwiseAbs().maxCoeff();
}

Pose ClosedMjcf::site(const char* name) const {
  const int id = mj_name2id(model.get(), mjOBJ_SITE, name);
  if (id < 0) throw std::runtime_error(std::string("no site ") + name);
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(data->site_xpos + 3 * id);
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data->site_xmat + 9 * id);
  return pose;
}

Jacobian ClosedMjcf::tool_jacobian() const {
  const int site = mj_name2id(model.get(), mjOBJ_SITE, "tool");
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> linear(3, model->nv), angular(3, model->nv);
  mj_jacSite(model.get(), data.get(), linear.data(), angular.data(), site);
  Eigen::MatrixXd twist(6, model->nv);
  twist << linear, angular;
  const Dense rows(data->efc_J, kEquations, model->nv);
  Matrix6 by_passive, by_driven, twist_by_passive;
  Jacobian result(6, 6);
  for (int i = 0; i < 6; ++i) {
    const auto each = static_cast<std::size_t>(i);
    by_passive.col(i) = rows.col(passive_[each]);
    by_driven.col(i) = rows.col(driven_[each]);
    twist_by_passive.col(i) = twist.col(passive_[each]);
    result.col(i) = twist.col(driven_[each]);
  }
  return result - twist_by_passive * by_passive.partialPivLu().solve(by_driven);
}

JointVector ClosedMjcf::holding_forces() {
  mj_fwdVelocity(model.get(), data.get());
  const Dense rows(data->efc_J, kEquations, model->nv);
  Matrix6 by_passive, by_driven;
  Eigen::Matrix<double, 6, 1> weight_on_passive, weight_on_driven;
  for (int i = 0; i < 6; ++i) {
    const auto each = static_cast<std::size_t>(i);
    by_passive.col(i) = rows.col(passive_[each]);
    by_driven.col(i) = rows.col(driven_[each]);
    weight_on_passive[i] = data->qfrc_bias[passive_[each]];
    weight_on_driven[i] = data->qfrc_bias[driven_[each]];
  }
  // the loops' forces carry the weight on joints without a drive
  const Eigen::Matrix<double, 6, 1> loops = by_passive.transpose().partialPivLu().solve(weight_on_passive);
  return weight_on_driven - by_driven.transpose() * loops;
}

}  // namespace mrroc
