#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <filesystem>
#include <optional>

namespace mrroc::sim {

/// A ball-nose cutter that removes material: a height field is carved along the cutter's true way, and the material
/// resists with a force that grows with the depth and the feed. The scene declares it in its custom section:
///
///     <tuple name="milling">                                  three geoms of the scene:
///       <element objtype="geom" objname="cutter"/>            a sphere, the nose of the cutter
///       <element objtype="geom" objname="wood"/>              a height field for pictures, which is carved
///       <element objtype="geom" objname="board"/>             a height field of the same frame and size, the surface
///       at the start
///     </tuple>
///     <numeric name="milling" data="K_c K_e k_t f"/>
///
/// In a physics step the cutter takes the volume dV off the wood and moves by ds. With the area A = dV/ds of the
/// chip's section, the diameter D and the feed v, smoothed over kSmoothing s,
///   F = (K_e + K_c v/f) A/D,
/// the mechanistic milling force of an engaged depth A/D and a feed per tooth v/f (Y. Altintas, Manufacturing
/// Automation, 2nd ed., 2.2): K_c in N/m^2, K_e in N/m, f in teeth per s. F acts against the motion, k_t F along the
/// cutter's axis out of the wood, at the nose's end. Wood that is gone does not resist: a groove is crossed freely.
///
/// The simulation's thread; `step` allocates nothing.
class Milling {
 public:
  static constexpr double kSmoothing = 0.005;  ///< s, some rotations of the spindle

  /// Finds the scene's declaration, and lays the wood's surface on the board's; empty without one. Throws
  /// config::ConfigurationError that names what is wrong with it.
  static std::optional<Milling> find(mjModel& model, const std::filesystem::path& scene);

  /// Removes what the cutter has reached and sets its force for the next physics step of `timestep` s.
  void step(mjModel& model, mjData& data, double timestep) noexcept;

  /// Carves the wood with the nose's centre at `centre`, in the frame of the height field, m. Returns the volume, m^3.
  double carve(mjModel& model, const Eigen::Vector3d& centre) const noexcept;

  /// The nose's centre in the frame of the height field, m, when the last physics step has removed something.
  const std::optional<Eigen::Vector3d>& removed_at() const noexcept { return removed_at_; }
  /// N, on the cutter, in the world.
  const Eigen::Vector3d& force() const noexcept { return force_; }

 private:
  struct Material {
    double cutting;  ///< K_c, N/m^2
    double edge;     ///< K_e, N/m
    double thrust;   ///< k_t
    double teeth;    ///< f, 1/s
  };
  Milling(const mjModel& model, int cutter, int wood, const Material& material);
  void find_force(double removed, const Eigen::Vector3d& moved, double timestep) noexcept;

  int cutter_, wood_;
  int field_;      ///< of `wood`
  double radius_;  ///< m
  Material material_;
  bool begun_ = false;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();  ///< of the nose's centre before the step, in the world
  double volume_rate_ = 0;                           ///< m^3/s
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_ = Eigen::Vector3d::Zero();  ///< out of the wood
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> removed_at_;
};

}  // namespace mrroc::sim
