#include "sim/milling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "config/table.hpp"

namespace mrroc::sim {

namespace {

using config::ConfigurationError;
using Matrix = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;

constexpr const char* kName = "milling";
constexpr double kSlow = 1e-6;  // m/s; slower, the direction of the feed is noise

Eigen::Vector3d position_of(const mjData& data, int geom) {
  return Eigen::Map<const Eigen::Vector3d>(data.geom_xpos + 3 * geom);
}

Matrix orientation_of(const mjData& data, int geom) { return Eigen::Map<const Matrix>(data.geom_xmat + 9 * geom); }

/// The three geoms of the declaration: sphere, height field, height field.
std::array<int, 3> geoms_of(const mjModel& model, int tuple, const std::filesystem::path& scene) {
  constexpr std::array<mjtGeom, 3> kTypes{mjGEOM_SPHERE, mjGEOM_HFIELD, mjGEOM_HFIELD};
  constexpr const char* kExpected = "three geoms: the cutter's sphere, the carved height field, that of the surface";
  if (model.tuple_size[tuple] != 3)
    throw ConfigurationError(scene, 0, "custom.tuple.milling", std::to_string(model.tuple_size[tuple]) + " elements",
                             kExpected);
  std::array<int, 3> geoms{};
  for (int i = 0; i < 3; ++i) {
    const int element = model.tuple_adr[tuple] + i;
    geoms[static_cast<std::size_t>(i)] = model.tuple_objid[element];
    if (model.tuple_objtype[element] != mjOBJ_GEOM ||
        model.geom_type[model.tuple_objid[element]] != kTypes[static_cast<std::size_t>(i)])
      throw ConfigurationError(scene, 0, "custom.tuple.milling",
                               "element " + std::to_string(i + 1) + " is another object", kExpected);
  }
  return geoms;
}

void check_same_place(const mjModel& model, int wood, int board, const std::filesystem::path& scene) {
  const auto same = [](const mjtNum* a, const mjtNum* b, int count) { return std::equal(a, a + count, b); };
  const int a = model.geom_dataid[wood], b = model.geom_dataid[board];
  if (model.geom_bodyid[wood] == model.geom_bodyid[board] &&
      same(model.geom_pos + 3 * wood, model.geom_pos + 3 * board, 3) &&
      same(model.geom_quat + 4 * wood, model.geom_quat + 4 * board, 4) &&
      same(model.hfield_size + 4 * a, model.hfield_size + 4 * b, 3))
    return;
  throw ConfigurationError(scene, 0, "custom.tuple.milling", "its height fields differ",
                           "the same body, position, orientation and size");
}

/// The elevation of field `from` between its points, at each point of field `to`.
void lay(mjModel& model, int to, int from) {
  const int rows = model.hfield_nrow[from], columns = model.hfield_ncol[from];
  const float* const known = model.hfield_data + model.hfield_adr[from];
  float* const laid = model.hfield_data + model.hfield_adr[to];
  for (int r = 0; r < model.hfield_nrow[to]; ++r) {
    const double y = static_cast<double>(r) * (rows - 1) / (model.hfield_nrow[to] - 1);
    const int below = std::min(static_cast<int>(y), rows - 2);
    for (int c = 0; c < model.hfield_ncol[to]; ++c) {
      const double x = static_cast<double>(c) * (columns - 1) / (model.hfield_ncol[to] - 1);
      const int left = std::min(static_cast<int>(x), columns - 2);
      const auto at = [&](int row, int column) { return static_cast<double>(known[row * columns + column]); };
      const auto along = [&](int row) { return at(row, left) + (x - left) * (at(row, left + 1) - at(row, left)); };
      laid[r * model.hfield_ncol[to] + c] =
          static_cast<float>(along(below) + (y - below) * (along(below + 1) - along(below)));
    }
  }
}

}  // namespace

std::optional<Milling> Milling::find(mjModel& model, const std::filesystem::path& scene) {
  const int tuple = mj_name2id(&model, mjOBJ_TUPLE, kName), numeric = mj_name2id(&model, mjOBJ_NUMERIC, kName);
  if (tuple < 0 && numeric < 0) return {};
  if (tuple < 0 || numeric < 0)
    throw ConfigurationError(scene, 0, "custom", tuple < 0 ? "no tuple \"milling\"" : "no numeric \"milling\"",
                             "both of this name");
  const auto [cutter, wood, board] = geoms_of(model, tuple, scene);
  check_same_place(model, wood, board, scene);
  const mjtNum* const data = model.numeric_data + model.numeric_adr[numeric];
  if (model.numeric_size[numeric] != 4 || !std::all_of(data, data + 4, [](mjtNum value) { return value >= 0; }) ||
      data[3] == 0)
    throw ConfigurationError(scene, 0, "custom.numeric.milling", "not four numbers of at least 0, the last above 0",
                             "K_c (N/m^2), K_e (N/m), k_t, teeth per s");
  lay(model, model.geom_dataid[wood], model.geom_dataid[board]);
  return Milling(model, cutter, wood, {data[0], data[1], data[2], data[3]});
}

Milling::Milling(const mjModel& model, int cutter, int wood, const Material& material)
    : cutter_(cutter),
      wood_(wood),
      field_(model.geom_dataid[wood]),
      radius_(model.geom_size[3 * cutter]),
      material_(material) {}

double Milling::carve(mjModel& model, const Eigen::Vector3d& centre) const noexcept {
  const int rows = model.hfield_nrow[field_], columns = model.hfield_ncol[field_];
  const mjtNum* const size = model.hfield_size + 4 * field_;
  float* const elevation = model.hfield_data + model.hfield_adr[field_];
  const double dx = 2 * size[0] / (columns - 1), dy = 2 * size[1] / (rows - 1);
  const auto first = [&](double from, double half, double step) {
    return std::max(0, static_cast<int>(std::ceil((from - radius_ + half) / step)));
  };
  const auto last = [&](double from, double half, double step, int count) {
    return std::min(count - 1, static_cast<int>(std::floor((from + radius_ + half) / step)));
  };
  double removed = 0;
  for (int r = first(centre.y(), size[1], dy); r <= last(centre.y(), size[1], dy, rows); ++r) {
    const double y = r * dy - size[1] - centre.y();
    for (int c = first(centre.x(), size[0], dx); c <= last(centre.x(), size[0], dx, columns); ++c) {
      const double x = c * dx - size[0] - centre.x();
      const double inside = radius_ * radius_ - x * x - y * y;
      if (inside < 0) continue;
      const auto left = static_cast<float>(std::max(0.0, (centre.z() - std::sqrt(inside)) / size[2]));
      float& present = elevation[r * columns + c];
      if (left >= present) continue;
      removed += static_cast<double>(present - left) * size[2] * dx * dy;
      present = left;
    }
  }
  return removed;
}

void Milling::step(mjModel& model, mjData& data, double timestep) noexcept {
  const Eigen::Vector3d place = position_of(data, cutter_);
  const Eigen::Vector3d moved = begun_ ? Eigen::Vector3d(place - place_) : Eigen::Vector3d::Zero();
  begun_ = true;
  place_ = place;
  const Matrix wood = orientation_of(data, wood_);
  const Eigen::Vector3d centre = wood.transpose() * (place - position_of(data, wood_));
  const double removed = carve(model, centre);
  removed_at_.reset();
  if (removed > 0) removed_at_ = centre;
  axis_ = -orientation_of(data, cutter_).col(2);
  find_force(removed, moved, timestep);

  const int body = model.geom_bodyid[cutter_];
  const Eigen::Vector3d arm = place - radius_ * axis_ - Eigen::Map<const Eigen::Vector3d>(data.xipos + 3 * body);
  Eigen::Map<Eigen::Matrix<mjtNum, 6, 1>> applied(data.xfrc_applied + 6 * body);
  applied.head<3>() = force_;
  applied.tail<3>() = arm.cross(force_);
}

void Milling::find_force(double removed, const Eigen::Vector3d& moved, double timestep) noexcept {
  const double share = std::min(1.0, timestep / kSmoothing);
  volume_rate_ += share * (removed / timestep - volume_rate_);
  velocity_ += share * (moved / timestep - velocity_);
  const double feed = velocity_.norm();
  force_.setZero();
  if (feed < kSlow || volume_rate_ <= 0) return;
  const double depth = volume_rate_ / feed / (2 * radius_);
  const double drag = (material_.edge + material_.cutting * feed / material_.teeth) * depth;
  force_ = drag * (material_.thrust * axis_ - velocity_ / feed);
}

}  // namespace mrroc::sim
