#include "sim/rendering/camera.hpp"

#include <algorithm>
#include <cmath>

#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "sim/scene/mujoco_messages.hpp"

namespace mrroc::sim {

namespace {

constexpr int kMaxGeoms = 10000;
constexpr int kShadowSize = 4096;

mjvCamera find_camera(const mjModel& model, const std::string& name) {
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  if (name.empty()) {
    mjv_defaultFreeCamera(&model, &camera);
    return camera;
  }
  camera.type = mjCAMERA_FIXED;
  camera.fixedcamid = mj_name2id(&model, mjOBJ_CAMERA, name.c_str());
  if (camera.fixedcamid >= 0) return camera;
  std::string list;
  for (const std::string& known : camera_names(model)) list += (list.empty() ? "" : ", ") + known;
  throw config::ConfigurationError({}, 0, "camera", "no camera \"" + name + "\"",
                                   list.empty() ? "none: the world has no camera" : "one of " + list);
}

}  // namespace

std::vector<std::string> camera_names(const mjModel& model) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(model.ncam));
  for (int i = 0; i < model.ncam; ++i) names.emplace_back(model.names + model.name_camadr[i]);
  return names;
}

Renderer::Renderer(mjModel& model, int width, int height, PictureQuality quality)
    : model_(model), data_(make_data(model)), width_(width), height_(height) {
  const MujocoMessages messages;
  model.vis.global.offwidth = width;
  model.vis.global.offheight = height;
  model.vis.quality.offsamples = quality.samples;
  model.vis.quality.shadowsize = std::max(model.vis.quality.shadowsize, kShadowSize);
  mjv_defaultScene(&scene_);
  mjr_defaultContext(&context_);
  try {
    mjv_makeScene(&model_, &scene_, kMaxGeoms);
    use_shadows(quality.shadows);
    mjr_makeContext(&model_, &context_, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
  } catch (const MujocoError& error) {
    mjv_freeScene(&scene_);
    throw SystemError(ErrorCode::resources, std::string("offscreen rendering: ") + error.what());
  }
}

Renderer::~Renderer() {
  mjr_freeContext(&context_);
  mjv_freeScene(&scene_);
}

Picture Renderer::render(const std::vector<double>& positions, const std::string& camera_name) {
  const MujocoMessages messages;
  if (static_cast<int>(positions.size()) != model_.nq) {
    throw config::ConfigurationError({}, 0, "state", std::to_string(positions.size()) + " positions",
                                     std::to_string(model_.nq) + ", as this world has");
  }
  const mjvCamera camera = find_camera(model_, camera_name);
  std::copy(positions.begin(), positions.end(), data_->qpos);
  update_poses();
  update_scene(camera);
  Picture picture;
  draw_scene(width_, height_, picture);
  return picture;
}

bool Renderer::place(const world::WorldSnapshot& snapshot) {
  if (static_cast<int>(snapshot.position_count) != model_.nq || static_cast<int>(snapshot.mocap_count) != model_.nmocap)
    return false;
  const MujocoMessages messages;
  const double* values = snapshot.values.data();
  std::copy_n(values, model_.nq, data_->qpos);
  std::copy_n(values + model_.nq, 3 * model_.nmocap, data_->mocap_pos);
  std::copy_n(values + model_.nq + 3 * model_.nmocap, 4 * model_.nmocap, data_->mocap_quat);
  update_poses();
  return true;
}

Pose Renderer::body_pose(int body) const {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body);
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * body);
  return pose;
}

void Renderer::draw(const Viewpoint& view, int width, int height, Picture& picture) {
  const MujocoMessages messages;
  mjvCamera camera;
  mjv_defaultFreeCamera(&model_, &camera);
  update_scene(camera);
  for (mjvGLCamera& eye : scene_.camera) {
    for (int i = 0; i < 3; ++i) {
      eye.pos[i] = static_cast<float>(view.pose.translation()[i]);
      eye.forward[i] = static_cast<float>(-view.pose.linear()(i, 2));
      eye.up[i] = static_cast<float>(view.pose.linear()(i, 1));
    }
    eye.frustum_center = 0;
    eye.frustum_top = eye.frustum_near * static_cast<float>(std::tan(view.field_of_view / 2));
    eye.frustum_bottom = -eye.frustum_top;
  }
  draw_scene(width, height, picture);
}

void Renderer::update_poses() {
  mj_kinematics(&model_, data_.get());
  mj_comPos(&model_, data_.get());
  mj_camlight(&model_, data_.get());
  mj_tendon(&model_, data_.get());
}

void Renderer::update_scene(mjvCamera camera) {
  mjvOption option;
  mjv_defaultOption(&option);
  option.flags[mjVIS_RANGEFINDER] = 0;
  mjv_updateScene(&model_, data_.get(), &option, nullptr, &camera, mjCAT_ALL, &scene_);
}

void Renderer::draw_scene(int width, int height, Picture& picture) {
  const mjrRect view{0, 0, width, height};
  mjr_render(view, &scene_, &context_);
  picture.width = width;
  picture.height = height;
  picture.pixels.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  mjr_readPixels(picture.pixels.data(), nullptr, view, &context_);
  const auto row = static_cast<std::ptrdiff_t>(3) * width;
  for (int top = 0, bottom = height - 1; top < bottom; ++top, --bottom) {  // OpenGL's rows go upwards
    std::swap_ranges(picture.pixels.begin() + top * row, picture.pixels.begin() + (top + 1) * row,
                     picture.pixels.begin() + bottom * row);
  }
}

}  // namespace mrroc::sim
