#pragma once

#include <filesystem>

namespace mrroc::can {

/// The socket at which a hub awaits its clients, and its file. Only the hub's user has access.
class HubListener {
 public:
  /// Listens at `path`. The socket of a killed hub is replaced; that of a running hub, or a file of another kind, is
  /// not. Throws std::runtime_error.
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
