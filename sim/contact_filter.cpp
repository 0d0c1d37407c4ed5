#include "sim/contact_filter.hpp"

#include <Eigen/Core>
#include <optional>

namespace mrroc::sim {

namespace {

using Eigen::Vector3d;
using Matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
using Vector = Eigen::Map<const Vector3d>;

/// Half the edges of the box round a geom, in its own axes.
std::optional<Vector3d> box_round(const mjModel& model, int geom) noexcept {
  const mjtNum* size = model.geom_size + 3 * geom;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return Vector3d::Constant(size[0]);
    case mjGEOM_CAPSULE:
      return Vector3d(size[0], size[0], size[0] + size[1]);
    case mjGEOM_CYLINDER:
      return Vector3d(size[0], size[0], size[1]);
    case mjGEOM_ELLIPSOID:
    case mjGEOM_BOX:
      return Vector3d(size[0], size[1], size[2]);
    default:
      return std::nullopt;
  }
}

bool is_masked(const mjModel& model, int first, int second) noexcept {
  return (model.geom_contype[first] & model.geom_conaffinity[second]) == 0 &&
         (model.geom_contype[second] & model.geom_conaffinity[first]) == 0;
}

/// Their bodies are rigidly one, or parent and child, neither of which is fixed in the world.
bool is_joined(const mjModel& model, int first, int second) noexcept {
  const int a = model.body_weldid[model.geom_bodyid[first]], b = model.body_weldid[model.geom_bodyid[second]];
  if (a == b) return true;
  if ((model.opt.disableflags & mjDSBL_FILTERPARENT) != 0 || a == 0 || b == 0) return false;
  return a == model.body_weldid[model.body_parentid[b]] || b == model.body_weldid[model.body_parentid[a]];
}

double margin(const mjModel& model, int first, int second) noexcept {
  if ((model.opt.enableflags & mjENBL_OVERRIDE) != 0) return model.opt.o_margin;
  return model.geom_margin[first] + model.geom_margin[second];
}

/// The box round one geom is farther than `reach` from the point `between` off its middle.
bool is_apart(const mjModel& model, const mjData& data, int boxed, const Vector3d& between, double reach) noexcept {
  const auto box = box_round(model, boxed);
  if (!box) return false;
  const Vector3d at = Matrix(data.geom_xmat + 9 * boxed).transpose() * between;
  return (at.cwiseAbs() - *box).cwiseMax(0).squaredNorm() > reach * reach;
}

/// The geoms' spheres, or one's box and the other's sphere, are farther apart than their margins.
bool is_apart(const mjModel& model, const mjData& data, int first, int second) noexcept {
  const double radius = model.geom_rbound[first], other = model.geom_rbound[second];
  if (radius <= 0 || other <= 0) return false;  // a plane's
  const double gap = margin(model, first, second), reach = radius + other + gap;
  const Vector3d between = Vector(data.geom_xpos + 3 * second) - Vector(data.geom_xpos + 3 * first);
  if (between.squaredNorm() > reach * reach) return true;
  return is_apart(model, data, first, between, other + gap) || is_apart(model, data, second, -between, radius + gap);
}

}  // namespace

int cannot_touch(const mjModel* model, mjData* data, int first, int second) noexcept {
  return is_masked(*model, first, second) || is_joined(*model, first, second) || is_apart(*model, *data, first, second);
}

}  // namespace mrroc::sim
