#include "sensors/camera/camera_sensor.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include <string>

#include "process/picture_memory.hpp"
#include "sensors/camera/configuration.hpp"
#include "sensors/camera/detection/make_detector.hpp"
#include "sensors/camera/keys.hpp"
#include "sensors/camera/pictures/hardware_camera.hpp"
#include "sensors/camera/pictures/simulated_camera.hpp"
#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

namespace {

void fill(SensorReading& v, const Detection& found, const Pose& camera) {
  const Eigen::Vector3d position = camera * found.pose.translation();
  Eigen::Quaterniond q(Eigen::Matrix3d(camera.linear() * found.pose.linear()));
  if (q.w() < 0) q.coeffs() *= -1;
  const Eigen::Vector3d deviation =
      (camera.linear() * found.covariance * camera.linear().transpose()).diagonal().cwiseMax(0).cwiseSqrt();
  v.values = {1,
              position.x(),
              position.y(),
              position.z(),
              q.w(),
              q.x(),
              q.y(),
              q.z(),
              deviation.x(),
              deviation.y(),
              deviation.z(),
              found.rotation_deviation,
              found.pixel.x(),
              found.pixel.y(),
              found.reprojection_error,
              found.area};
}

}  // namespace

void CameraSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  cv::setNumThreads(1);  // threads slow down small pictures, and lockstep runs on one CPU
  entry_ = entry;
  detector_ = make_detector(entry);
}

std::unique_ptr<Source> CameraSensor::open_source(const SourceContext& context) {
  const config::SensorEntry& entry = context.entry;
  std::unique_ptr<PictureSource> source;
  if (entry.source == "hardware") {
    source = open_device(context, picture_);
    shown_ = context.pictures;
  } else {
    source = std::make_unique<SimulatedCamera>(context, picture_);
  }
  intrinsics_ = source->intrinsics();
  intrinsics_.fx *= number(entry, "focal_scale");
  intrinsics_.fy *= number(entry, "focal_scale");
  frame_ = ReadingFrame(context.deployment, entry, calibrated_mount(entry).value_or(source->mount()));
  source_ = source.get();
  part_ = part_of(intrinsics_, Region{});
  check_view(*detector_, entry);
  if (!text(entry, "debug").empty()) {
    debug_.emplace(text(entry, "debug"), entry.name, whole(entry, "debug_every"), intrinsics_);
  }
  return source;
}

/// Where the camera is fixed, it must be able to see what it looks for.
void CameraSensor::check_view(const Detector& detector, const config::SensorEntry& entry) const {
  if (frame_.moves()) return;
  const std::string_view obstacle = detector.obstacle(intrinsics_, frame_.of_camera(Pose::Identity()).inverse());
  if (!obstacle.empty()) refuse(entry, "plane", std::string(obstacle), "a plane that the camera sees");
}

void CameraSensor::reconfigure(const Message& configuration) {
  take_configuration<LookFor, LookForColour, Region, Exposure>(configuration,
                                                               [this](const auto& taken) { apply(taken); });
}

void CameraSensor::look_for(config::SensorEntry entry) {
  std::unique_ptr<Detector> detector = make_detector(entry);
  check_view(*detector, entry);
  detector_ = std::move(detector);
  entry_ = std::move(entry);
}

void CameraSensor::apply(const LookFor& marker) { look_for(with(entry_, marker)); }

void CameraSensor::apply(const LookForColour& blob) { look_for(with(entry_, blob)); }

void CameraSensor::apply(const Region& region) { part_ = part_of(intrinsics_, region); }

void CameraSensor::apply(const Exposure& exposure) {
  check_configured("Exposure", "seconds", exposure.seconds, 1e-6, 10, "s");
  source_->expose(exposure.seconds);
}

void CameraSensor::effector_state(const RobotState& e) noexcept {
  flange_.reset();  // a robot that has lost its synchronisation has no pose
  if (e.synchronised) flange_ = e.pose * e.tool.inverse();
}

/// For the programs beside the run; a picture that several readings use, once.
void CameraSensor::show(const RawReading& r) noexcept {
  if (shown_ == nullptr || r.values[0] == shown_number_ || !picture_.isContinuous()) return;
  const std::size_t bytes = picture_.total() * picture_.elemSize();
  if (bytes != shown_->bytes()) return;
  shown_->store(r.tick, {picture_.data, bytes});
  shown_number_ = r.values[0];
}

void CameraSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  show(r);
  if (frame_.moves() && !flange_) {
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_not_ready,
                  "the camera's pose needs the pose of a synchronised robot");
  }
  try {
    detect(v);
  } catch (const std::exception& error) {
    report(v, ErrorClass::hardware, ErrorCode::sensor_hardware, "%s", error.what());
  }
}

void CameraSensor::detect(SensorReading& v) {
  const Pose camera = frame_.of_camera(flange_.value_or(Pose::Identity()));
  const Pose reference = camera.inverse();
  if (frame_.moves()) {
    const std::string obstacle(detector_->obstacle(intrinsics_, reference));
    if (!obstacle.empty()) {
      return report(v, ErrorClass::non_fatal, ErrorCode::sensor_out_of_range, "%s", obstacle.c_str());
    }
  }
  std::optional<Detection> found = detector_->find(picture_(part_), cropped(intrinsics_, part_), reference);
  if (found) {
    const Eigen::Vector2d corner(part_.x, part_.y);
    found->pixel += corner;
    for (Eigen::Vector2d& point : found->outline) point += corner;
    fill(v, *found, camera);
  } else {
    std::fill_n(v.values.begin(), v.channel_count, 0.0);
  }
  if (debug_) debug_->show(picture_, found ? &*found : nullptr, v);
}

}  // namespace mrroc::vsp
