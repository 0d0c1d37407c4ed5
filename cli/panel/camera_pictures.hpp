#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "cli/pictures/camera_views.hpp"
#include "config/deployment.hpp"
#include "mrroc/types.hpp"

namespace mrroc::cli {

/// A picture of a camera, or the reason why it is missing.
struct CameraPicture {
  Tick tick = 0;               ///< of the world's state that it shows
  std::vector<std::byte> png;  ///< empty: `reason`
  std::string reason;
};

/// Pictures of a deployment's cameras for browsers, when one asks; all browsers receive the same one. Those of
/// simulated cameras are drawn in this process from the run's events "world" (PictureDrawer), one after the other in a
/// thread of low priority: the run does nothing for them. Those of hardware are of its newest reading (HardwareView).
class CameraPictures {
 public:
  static constexpr std::chrono::seconds kLongestWait{3};

  /// As `camera_views`. `longest_wait`: for the first state, and for a picture.
  explicit CameraPictures(const config::Deployment& deployment, const std::map<std::string, std::string>& files = {},
                          std::chrono::seconds longest_wait = kLongestWait);
  ~CameraPictures();
  CameraPictures(const CameraPictures&) = delete;
  CameraPictures& operator=(const CameraPictures&) = delete;

  /// The deployment's cameras, in its order. Any thread.
  const std::vector<ShownCamera>& cameras() const noexcept { return views_.cameras; }
  /// Takes the run's newest event "world". Any thread; it draws nothing.
  void take(const std::string& event);
  /// The picture of the newest state, seen by `camera`; null: no such camera. Waits for the
  /// first state, and until the picture is drawn, for `longest_wait` each at most.
  /// Any thread.
  std::shared_ptr<const CameraPicture> picture(std::string_view camera);

 private:
  struct Drawn {
    bool wanted = false;
    std::uint64_t event = 0;  ///< number of the event that `picture` shows
    std::shared_ptr<const CameraPicture> picture;
  };

  std::shared_ptr<const CameraPicture> drawn_picture(std::string_view camera);
  std::shared_ptr<const CameraPicture> hardware_picture(std::string_view camera, HardwareView& view);
  void draw_pictures();

  std::chrono::seconds longest_wait_;
  CameraViews views_;
  std::mutex mutex_;
  std::condition_variable arrived_, asked_, drawn_;
  std::map<std::string, Drawn, std::less<>> pictures_;
  std::string newest_;        ///< event "world"
  std::uint64_t events_ = 0;  ///< taken
  bool ended_ = false;
  std::thread thread_;  ///< from the first picture on
};

}  // namespace mrroc::cli
