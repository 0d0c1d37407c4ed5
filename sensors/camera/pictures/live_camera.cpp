#include "sensors/camera/pictures/live_camera.hpp"

#include <opencv2/imgproc.hpp>
#include <utility>

#include "mrroc/errors.hpp"

namespace mrroc::vsp {

LiveCamera::LiveCamera(Take take, Expose expose, HardwareCamera camera, Tick silent_after, cv::Mat& picture)
    : take_(std::move(take)),
      expose_(std::move(expose)),
      camera_(std::move(camera)),
      silent_after_(silent_after),
      picture_(&picture),
      thread_([this] { take_pictures(); }) {}

LiveCamera::~LiveCamera() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  thread_.join();
}

void LiveCamera::take_pictures() {
  cv::Mat taken, picture;
  bool alive = true;
  while (alive) {
    try {
      alive = take_(taken) && taken.cols == camera_.intrinsics.width && taken.rows == camera_.intrinsics.height;
      if (alive) cv::cvtColor(taken, picture, cv::COLOR_BGR2RGB);
    } catch (const std::exception&) {
      alive = false;
    }
    const std::lock_guard lock(mutex_);
    ended_ = !alive;
    if (ended_) exposed_.notify_one();
    if (stop_) return;
    if (!alive) continue;
    if (++taken_ >= not_before_) std::swap(newest_, picture);
    if (exposure_) {
      exposure_refused_ = !expose_(*exposure_);
      exposure_.reset();
      if (!exposure_refused_) not_before_ = taken_ + kQueued + 1;
      exposed_.notify_one();
    }
  }
}

void LiveCamera::expose(double seconds) {
  std::unique_lock lock(mutex_);
  exposure_ = seconds;
  exposed_.wait(lock, [this] { return !exposure_ || ended_; });
  if (std::exchange(exposure_, std::nullopt))
    throw HardwareError(ErrorCode::sensor_hardware, "the camera has ended, its exposure cannot be set");
  if (exposure_refused_) refuse_configuration("Exposure", "seconds", seconds, "an exposure that the camera can make");
  seen_ = taken_;
  current_ = false;  // the picture that has come was exposed as before
}

/// Whether the device works; then its newest picture is in `picture_`.
bool LiveCamera::fetch() noexcept {
  const std::lock_guard lock(mutex_);
  if (taken_ != seen_ && taken_ >= not_before_) {
    std::swap(newest_, *picture_);
    seen_ = taken_;
    current_ = true;
  }
  return !ended_;
}

SourceState LiveCamera::read(Tick wanted, RawReading& raw) noexcept {
  const std::uint64_t before = seen_;
  if (!fetch()) return SourceState::silent;
  if (seen_ != before || seen_at_ == kNever) seen_at_ = wanted;
  if (wanted - seen_at_ > silent_after_) return SourceState::silent;
  if (!current_) return SourceState::not_ready;
  raw.tick = seen_at_;
  raw.count = 1;
  raw.values[0] = static_cast<double>(seen_);
  return SourceState::ready;
}

}  // namespace mrroc::vsp
