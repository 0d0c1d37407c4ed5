#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "sensors/camera/pictures/hardware_camera.hpp"

namespace mrroc::vsp {

/// A hardware camera. Its own thread takes pictures as they come, so that `read` never waits for one: it returns the
/// newest, with the tick at which it was first seen here, at most one picture's time and one reading's period late.
/// Silent when none has come for `silent_after` ticks, or the device has ended.
class LiveCamera final : public PictureSource {
 public:
  /// Takes the next picture (8-bit BGR of the camera's size), waiting for it; false: the device has ended.
  using Take = std::function<bool(cv::Mat&)>;
  /// Sets the exposure, s, in the thread that takes pictures; false: the device refuses.
  using Expose = std::function<bool(double)>;
  /// Pictures that a device may have exposed before it gives the first one of a new exposure: those in its queue.
  static constexpr std::uint64_t kQueued = 4;
  LiveCamera(Take take, Expose expose, HardwareCamera camera, Tick silent_after, cv::Mat& picture);
  /// Waits for the picture that is being taken.
  ~LiveCamera() override;
  LiveCamera(const LiveCamera&) = delete;
  LiveCamera& operator=(const LiveCamera&) = delete;

  SourceState read(Tick wanted, RawReading& raw) noexcept override;
  const Intrinsics& intrinsics() const noexcept override { return camera_.intrinsics; }
  const Pose& mount() const noexcept override { return camera_.mount; }
  /// Waits for the picture that is being taken; pictures up to kQueued after it are not read.
  void expose(double seconds) override;

 private:
  void take_pictures();
  bool fetch() noexcept;

  Take take_;
  Expose expose_;
  HardwareCamera camera_;
  Tick silent_after_;
  cv::Mat* picture_;
  bool current_ = false;    ///< `picture_` has one that may be read
  std::uint64_t seen_ = 0;  ///< pictures that have come up to the one in `picture_`
  Tick seen_at_ = kNever;   ///< that one's tick, or that of the first `read`

  std::mutex mutex_;  ///< of all below
  cv::Mat newest_;
  std::uint64_t taken_ = 0;
  std::uint64_t not_before_ = 0;    ///< the first picture that may be read
  std::optional<double> exposure_;  ///< to be set before the next picture
  bool exposure_refused_ = false;
  std::condition_variable exposed_;
  bool ended_ = false;
  bool stop_ = false;
  std::thread thread_;  ///< last: it uses all above
};

}  // namespace mrroc::vsp
