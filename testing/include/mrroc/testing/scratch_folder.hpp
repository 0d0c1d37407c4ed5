#pragma once

#include <filesystem>
#include <string>

namespace mrroc::task_test {

/// A new folder below the system's folder for temporary files, removed with all that is in it when this object goes.
/// One thread.
class ScratchFolder {
 public:
  /// Throws std::runtime_error when there is no place for it.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  /// Writes a file into it and returns its path. Throws std::runtime_error when it cannot be written.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace mrroc::task_test
