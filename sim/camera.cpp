#include "sim/camera.hpp"

#include <algorithm>

#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "sim/mujoco_messages.hpp"

namespace mrroc::sim {

namespace {

constexpr int kMaxGeoms = 10000;
constexpr int kSamples = 4;
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
  for (int i = 0; i < model.ncam; ++i) {
    list += (list.empty() ? "" : ", ") + std::string(model.names + model.name_camadr[i]);
  }
  throw config::ConfigurationError({}, 0, "camera", "no camera \"" + name + "\"",
                                   list.empty() ? "none: the world has no camera" : "one of " + list);
}

}  // namespace

Renderer::Renderer(mjModel& model, int width, int height)
    : model_(model), data_(make_data(model)), width_(width), height_(height) {
  const MujocoMessages messages;
  model.vis.global.offwidth = width;
  model.vis.global.offheight = height;
  model.vis.quality.offsamples = kSamples;
  model.vis.quality.shadowsize = std::max(model.vis.quality.shadowsize, kShadowSize);
  mjv_defaultScene(&scene_);
  mjr_defaultContext(&context_);
  try {
    mjv_makeScene(&model_, &scene_, kMaxGeoms);
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
  mjvCamera camera = find_camera(model_, camera_name);
  std::copy(positions.begin(), positions.end(), data_->qpos);
  mj_kinematics(&model_, data_.get());
  mj_comPos(&model_, data_.get());
  mj_camlight(&model_, data_.get());
  mj_tendon(&model_, data_.get());

  mjvOption option;
  mjv_defaultOption(&option);
  option.flags[mjVIS_RANGEFINDER] = 0;
  mjv_updateScene(&model_, data_.get(), &option, nullptr, &camera, mjCAT_ALL, &scene_);
  const mjrRect view{0, 0, width_, height_};
  mjr_render(view, &scene_, &context_);

  Picture picture{width_, height_, {}};
  picture.pixels.resize(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  mjr_readPixels(picture.pixels.data(), nullptr, view, &context_);
  const auto row = static_cast<std::ptrdiff_t>(3) * width_;
  for (int top = 0, bottom = height_ - 1; top < bottom; ++top, --bottom) {  // OpenGL's rows go upwards
    std::swap_ranges(picture.pixels.begin() + top * row, picture.pixels.begin() + (top + 1) * row,
                     picture.pixels.begin() + bottom * row);
  }
  return picture;
}

}  // namespace mrroc::sim
