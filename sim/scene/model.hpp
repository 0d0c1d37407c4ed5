#pragma once

#include <mujoco/mujoco.h>

#include <memory>

#include "sim/scene/compose.hpp"

namespace mrroc::sim {

struct DeleteModel {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, DeleteModel>;
using Data = std::unique_ptr<mjData, DeleteData>;

/// Compiles a composed world. Throws config::ConfigurationError with MuJoCo's own message and the position of the
/// element it means: the file (scene or robot) and the line *there*; also for a wrong declaration of milling.
Model load_model(const Composition& composition);

/// Memory for the state of `model`, at its initial configuration. Throws SystemError without memory.
Data make_data(const mjModel& model);

/// "joint arm/axis1", "body box", ... of a degree of freedom; "" when out of range.
std::string name_of_dof(const mjModel& model, int dof);
/// The same for an index into qpos.
std::string name_of_position(const mjModel& model, int index);

}  // namespace mrroc::sim
