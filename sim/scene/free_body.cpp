#include "sim/scene/free_body.hpp"

#include <algorithm>

#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::sim {

FreeBody::FreeBody(const mjModel& model, const std::string& name, const std::string& key)
    : body_(mj_name2id(&model, mjOBJ_BODY, name.c_str())) {
  if (body_ < 0) {
    throw config::ConfigurationError({}, 0, key, "the scene has no body " + config::in_quotes(name),
                                     "a free body of it");
  }
  if (model.body_jntnum[body_] != 1 || model.jnt_type[model.body_jntadr[body_]] != mjJNT_FREE) {
    throw config::ConfigurationError({}, 0, key, "body " + config::in_quotes(name) + " is not free",
                                     "a <freejoint/> in it");
  }
}

void FreeBody::hold(mjModel& model, mjData& data) {
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.body_rootid[model.geom_bodyid[geom]] != body_) continue;
    touches_.push_back({geom, model.geom_contype[geom], model.geom_conaffinity[geom]});
    model.geom_contype[geom] = model.geom_conaffinity[geom] = 0;
  }
  for (int body = body_; body < model.nbody; ++body) {
    if (model.body_rootid[body] != body_) continue;
    for (int axis = 0; axis < 3; ++axis)
      data.xfrc_applied[6 * body + axis] = -model.body_mass[body] * model.opt.gravity[axis];
  }
}

void FreeBody::put(mjModel& model, mjData& data, const Pose& pose) const {
  for (const Touch& touch : touches_) {
    model.geom_contype[touch.geom] = touch.type;
    model.geom_conaffinity[touch.geom] = touch.affinity;
  }
  for (int body = body_; body < model.nbody; ++body)
    if (model.body_rootid[body] == body_) std::fill_n(data.xfrc_applied + 6 * body, 6, 0.0);
  const int joint = model.body_jntadr[body_];
  mjtNum* position = data.qpos + model.jnt_qposadr[joint];
  const Eigen::Quaterniond q(pose.linear());
  Eigen::Map<Eigen::Vector3d>(position, 3) = pose.translation();
  position[3] = q.w(), position[4] = q.x(), position[5] = q.y(), position[6] = q.z();
  std::fill_n(data.qvel + model.jnt_dofadr[joint], 6, 0.0);
}

}  // namespace mrroc::sim
