#include "sim/scene/weld_torques.hpp"

#include <Eigen/Geometry>

namespace mrroc::sim {

namespace {

using Eigen::Vector3d;
using Matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

constexpr int kRelativePose = 6, kTorqueScale = 10;  // in eq_data of a weld

Eigen::Quaterniond quaternion(const double* wxyz) noexcept { return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]}; }

bool in_subtree(const mjModel& model, int body, int root) noexcept {
  while (body > root) body = model.body_parentid[body];
  return body == root;
}

/// Of an equality that is a weld and on, its first row; -1 else.
int first_row(const mjModel& model, const mjData& data, int weld) noexcept {
  for (int row = 0; row < data.ne;) {
    const int equality = data.efc_id[row];
    if (equality == weld) return row;
    const int type = model.eq_type[equality];
    row += type == mjEQ_WELD ? 6 : type == mjEQ_CONNECT ? 3 : 1;
  }
  return -1;
}

}  // namespace

WeldTorques::WeldTorques(const mjModel& model) {
  for (int sensor = 0; sensor < model.nsensor; ++sensor) {
    if (model.sensor_type[sensor] != mjSENS_TORQUE) continue;
    const int site = model.sensor_objid[sensor], root = model.site_bodyid[site];
    for (int weld = 0; weld < model.neq; ++weld) {
      if (model.eq_type[weld] != mjEQ_WELD) continue;
      const bool first = in_subtree(model, model.eq_obj1id[weld], root);
      if (first == in_subtree(model, model.eq_obj2id[weld], root)) continue;  // both: seen as an inner torque
      // the sensor measures the parent's torque on the subtree, which balances all others
      sensed_.push_back({site, model.sensor_adr[sensor], weld, first ? -1.0 : 1.0});
    }
  }
}

void WeldTorques::correct(const mjModel& model, mjData& data) const noexcept {
  for (const Sensed& sensed : sensed_) {
    const int row = first_row(model, data, sensed.weld);
    if (row < 0) continue;
    const double* const numbers = model.eq_data + mjNEQDATA * sensed.weld;
    const int body0 = model.eq_obj1id[sensed.weld], body1 = model.eq_obj2id[sensed.weld];
    const Eigen::Quaterniond error = quaternion(data.xquat + 4 * body1).conjugate() *
                                     quaternion(data.xquat + 4 * body0) * quaternion(numbers + kRelativePose);
    const Vector3d reported = Eigen::Map<const Vector3d>(data.efc_force + row + 3);
    const Vector3d torque = 0.5 * numbers[kTorqueScale] * Matrix(data.xmat + 9 * body1) *
                            (error.w() * reported + error.vec().cross(reported));
    Eigen::Map<Vector3d>(data.sensordata + sensed.address) +=
        sensed.sign * Matrix(data.site_xmat + 9 * sensed.site).transpose() * (torque - reported);
  }
}

}  // namespace mrroc::sim
