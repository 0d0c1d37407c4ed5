#include "cli/panel/scene.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "config/robot_parameters_file.hpp"
#include "config/table.hpp"

namespace mrroc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kShownGroups = 3;
constexpr int kDigitalOutputs = 16, kAnalogueOutputs = 8;

template <class Number>
Json numbers(std::span<const Number> values) {
  Json array = Json::array();
  for (const Number value : values) array.push_back(value);
  return array;
}

Json vector(const mjtNum* values, std::size_t count) { return numbers(std::span<const mjtNum>(values, count)); }

/// MuJoCo's w x y z as x y z w.
Json quaternion(const mjtNum* q) { return Json::array({q[1], q[2], q[3], q[0]}); }

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t block = 0;
    for (std::size_t j = 0; j < 3; ++j) block = block << 8 | (i + j < bytes.size() ? bytes[i + j] : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += i + j > bytes.size() ? '=' : kDigits[block >> (18 - 6 * j) & 63];
  }
  return text;
}

template <class Value>
std::string base64_of(const Value* values, std::size_t count) {
  return base64({reinterpret_cast<const std::uint8_t*>(values), count * sizeof(Value)});
}

const char* type_name(int type) {
  switch (type) {
    case mjGEOM_PLANE:
      return "plane";
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_MESH:
      return "mesh";
    default:
      return nullptr;  // height fields
  }
}

Json geoms_of(const mjModel& model) {
  Json geoms = Json::array();
  for (int i = 0; i < model.ngeom; ++i) {
    const char* const type = type_name(model.geom_type[i]);
    const int material = model.geom_matid[i];
    const float* const colour = material >= 0 ? model.mat_rgba + 4 * material : model.geom_rgba + 4 * i;
    if (type == nullptr || model.geom_group[i] >= kShownGroups || colour[3] <= 0) continue;
    Json geom{{"body", model.geom_bodyid[i]},
              {"type", type},
              {"size", vector(model.geom_size + 3 * i, 3)},
              {"position", vector(model.geom_pos + 3 * i, 3)},
              {"quaternion", quaternion(model.geom_quat + 4 * i)},
              {"colour", numbers(std::span<const float>(colour, 4))}};
    if (model.geom_type[i] == mjGEOM_MESH) geom["mesh"] = model.geom_dataid[i];
    geoms.push_back(std::move(geom));
  }
  return geoms;
}

Json meshes_of(const mjModel& model) {
  Json meshes = Json::array();
  for (int i = 0; i < model.nmesh; ++i) {
    const auto vertices = 3 * static_cast<std::size_t>(model.mesh_vertnum[i]);
    const auto triangles = 3 * static_cast<std::size_t>(model.mesh_facenum[i]);
    meshes.push_back({{"vertices", base64_of(model.mesh_vert + 3 * model.mesh_vertadr[i], vertices)},
                      {"triangles", base64_of(model.mesh_face + 3 * model.mesh_faceadr[i], triangles)}});
  }
  return meshes;
}

Json frames_of(const mjModel& model) {
  Json frames = Json::array();
  for (int i = 0; i < model.nsite; ++i)
    frames.push_back({{"name", model.names + model.name_siteadr[i]},
                      {"body", model.site_bodyid[i]},
                      {"position", vector(model.site_pos + 3 * i, 3)},
                      {"quaternion", quaternion(model.site_quat + 4 * i)}});
  return frames;
}

Json index_or_null(int index) { return index >= 0 ? Json(index) : Json(); }

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// Null without the model or the name.
Json index_of(const mjModel* model, int kind, const std::string& name) {
  return index_or_null(model != nullptr ? mj_name2id(model, kind, name.c_str()) : -1);
}

bool slides(const mjModel* model, const std::string& joint) {
  const Json index = index_of(model, mjOBJ_JOINT, joint);
  return !index.is_null() && model->jnt_type[index.get<int>()] == mjJNT_SLIDE;
}

Json robot_of(const mjModel* model, const config::RobotEntry& robot) {
  const RobotParameters parameters = config::read_robot_parameters(config::Table::load(robot.files().parameters));
  Json axes = Json::array(), motors = Json::array(), postures = Json::array(), tools = Json::array(),
       bodies = Json::array();
  for (const AxisParameters& axis : parameters.axes) {
    motors.push_back(axis.name);
    axes.push_back({{"name", axis.name},
                    {"unit", slides(model, robot.name + "/" + axis.name) ? "m" : "rad"},
                    {"minimum", finite_or_null(axis.position_min)},
                    {"maximum", finite_or_null(axis.position_max)},
                    {"velocity", axis.velocity_max}});
  }
  for (const auto& [name, posture] : parameters.postures) postures.push_back(name);
  for (const auto& [name, frame] : parameters.tools) tools.push_back(name);
  for (int i = 0; model != nullptr && i < model->nbody; ++i) {
    const std::string name = model->names + model->name_bodyadr[i];
    if (name == robot.name || name.starts_with(robot.name + "/")) bodies.push_back(i);
  }
  return {{"name", robot.name},
          {"type", robot.type},
          {"hardware", robot.driver.name},
          {"axes", axes},
          {"motors", motors},
          {"postures", postures},
          {"tools", tools},
          {"bodies", bodies},
          {"force_sensor", !robot.force_sensor.empty()},
          {"tool_frame", index_of(model, mjOBJ_SITE, robot.name + "/tool")},
          {"digital_outputs", kDigitalOutputs},
          {"analogue_outputs", kAnalogueOutputs}};
}

Json sensor_of(const mjModel* model, const config::SensorEntry& sensor) {
  Json channels = Json::array();
  for (const config::Channel& channel : sensor.channels) channels.push_back(channel.name);
  const std::string site = sensor.robot.empty() ? sensor.name : sensor.robot + "/wrist";
  return {{"name", sensor.name},
          {"type", sensor.type},
          {"robot", sensor.robot.empty() ? Json() : Json(sensor.robot)},
          {"channels", channels},
          {"frame", index_of(model, mjOBJ_SITE, site)}};
}

}  // namespace

std::string scene_json(const mjModel* model, const config::Deployment& deployment,
                       std::span<const ShownCamera> cameras) {
  const Json none = Json::array();
  Json json{{"deployment", deployment.name},
            {"servo_period", deployment.servo_period},
            {"robots", none},
            {"sensors", none},
            {"cameras", none},
            {"bodies", none},
            {"geoms", model != nullptr ? geoms_of(*model) : none},
            {"meshes", model != nullptr ? meshes_of(*model) : none},
            {"frames", model != nullptr ? frames_of(*model) : none}};
  for (const config::RobotEntry& robot : deployment.robots) json["robots"].push_back(robot_of(model, robot));
  for (const config::SensorEntry& sensor : deployment.sensors) json["sensors"].push_back(sensor_of(model, sensor));
  for (const ShownCamera& camera : cameras)
    json["cameras"].push_back({{"name", camera.name},
                               {"width", camera.width},
                               {"height", camera.height},
                               {"reason", camera.reason.empty() ? Json() : Json(camera.reason)}});
  for (int i = 0; model != nullptr && i < model->nbody; ++i)
    json["bodies"].push_back(
        {{"name", model->names + model->name_bodyadr[i]}, {"parent", i == 0 ? -1 : model->body_parentid[i]}});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mrroc::cli
