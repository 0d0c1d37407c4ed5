#pragma once

#include <mujoco/mujoco.h>

namespace mrroc::sim {

/// Whether MuJoCo can skip two geoms in its search for contacts; its `mjcb_contactfilter`, which replaces all of
/// its own rules but <pair> and <exclude>. It can when
///  - contype and conaffinity do not meet, or their bodies are rigidly one, or parent and child: MuJoCo's own rules;
///  - the box round one and the sphere round the other are farther apart than their margins. MuJoCo 2.2 compares
///  nothing
///    but spheres before it computes a contact, and that of a belt 2 m long holds the whole arm beside it.
/// No contact is lost: a box or a sphere contains all of its geom. Planes, meshes and height fields have none here and
/// are left to MuJoCo. Any thread.
int cannot_touch(const mjModel* model, mjData* data, int first, int second) noexcept;

}  // namespace mrroc::sim
