#include "sim/scene/model.hpp"

#include <array>
#include <cstring>

#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "sim/milling.hpp"
#include "sim/scene/mujoco_error_text.hpp"
#include "sim/scene/mujoco_messages.hpp"

namespace mrroc::sim {

namespace {

/// The n-th sensor of the world: MuJoCo reports the number of a sensor instead of its line.
Origin origin_of_sensor(const Composition& composition, std::size_t index) {
  for (const Element& section : composition.root.children) {
    if (section.name != "sensor") continue;
    if (index < section.children.size()) return section.children[index].origin;
    index -= section.children.size();
  }
  return composition.root.origin;
}

Origin origin_of(const Composition& composition, const MujocoErrorText& error) {
  if (error.line && *error.line >= 1 && *error.line <= composition.text.lines.size()) {
    return composition.text.lines[*error.line - 1];
  }
  if (error.id && error.text.find("sensor") != std::string::npos) return origin_of_sensor(composition, *error.id);
  return composition.root.origin;
}

[[noreturn]] void refuse(const Composition& composition, const char* message) {
  const MujocoErrorText error = parse_mujoco_error(message);
  const Origin origin = origin_of(composition, error);
  throw config::ConfigurationError(*origin.file, origin.line, "", "MuJoCo: " + error.text, "");
}

struct Vfs {
  Vfs() : vfs(std::make_unique<mjVFS>()) { mj_defaultVFS(vfs.get()); }
  ~Vfs() { mj_deleteVFS(vfs.get()); }
  Vfs(const Vfs&) = delete;
  Vfs& operator=(const Vfs&) = delete;
  std::unique_ptr<mjVFS> vfs;  // two megabytes
};

constexpr const char* kFile = "world.xml";

std::string object_name(const mjModel& model, const char* kind, mjtObj type, int id) {
  const char* name = mj_id2name(&model, type, id);
  const bool named = name != nullptr && *name != '\0';
  return std::string(kind) + " " + (named ? name : std::to_string(id));
}

/// A free or ball joint rarely has a name: then its body's name is used.
std::string joint_name(const mjModel& model, int joint) {
  const char* name = mj_id2name(&model, mjOBJ_JOINT, joint);
  if (name != nullptr && *name != '\0') return object_name(model, "joint", mjOBJ_JOINT, joint);
  return object_name(model, "body", mjOBJ_BODY, model.jnt_bodyid[joint]);
}

}  // namespace

Model load_model(const Composition& composition) {
  const MujocoMessages messages;
  const std::string& text = composition.text.text;
  std::array<char, 1000> error{};
  Vfs files;
  try {
    mj_makeEmptyFileVFS(files.vfs.get(), kFile, static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(),
              static_cast<char*>(files.vfs->filedata[mj_findFileVFS(files.vfs.get(), kFile)]));
    Model model(mj_loadXML(kFile, files.vfs.get(), error.data(), static_cast<int>(error.size())));
    if (!model) refuse(composition, error.data());
    if (!messages.warnings().empty()) refuse(composition, messages.warnings().front().c_str());
    Milling::find(*model, composition.scene);  // every picture shows the surface at the start
    return model;
  } catch (const MujocoError& mujoco_error) {
    refuse(composition, mujoco_error.what());
  }
}

Data make_data(const mjModel& model) {
  const MujocoMessages messages;
  try {
    Data data(mj_makeData(&model));
    if (data) return data;
  } catch (const MujocoError& error) {
    throw SystemError(ErrorCode::resources, std::string("memory of the simulated world: ") + error.what());
  }
  throw SystemError(ErrorCode::resources, "memory of the simulated world");
}

std::string name_of_dof(const mjModel& model, int dof) {
  return dof >= 0 && dof < model.nv ? joint_name(model, model.dof_jntid[dof]) : "";
}

std::string name_of_position(const mjModel& model, int index) {
  int joint = -1;
  while (joint + 1 < model.njnt && model.jnt_qposadr[joint + 1] <= index) ++joint;
  return joint >= 0 && index < model.nq ? joint_name(model, joint) : "";
}

}  // namespace mrroc::sim
