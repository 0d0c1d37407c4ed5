#pragma once

#include <filesystem>

namespace mrroc::can {

/// The socket at which a hub awaits its clients, and its file. Open to the hub's user alone.
class HubListener {
 public:
  /// Listens at `path`. A socket that a killed hub has left there is replaced; one of a living hub, or a file of
  /// another kind, is not. Throws std::runtime_error.
  explicit HubListener(std::filesystem::path path);
  /// Removes the file.
  ~HubListener();
  HubListener(const HubListener&) = delete;
  HubListener& operator=(const HubListener&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  int fd() const noexcept { return fd_; }

 private:
  std::filesystem::path path_;
  int fd_;
};

}  // namespace mrroc::can
