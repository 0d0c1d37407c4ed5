#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace mrroc::cli {

/// A folder that becomes visible under its name only when it is complete. One thread.
class NewFolder {
 public:
  /// Makes a hidden folder beside `target`. Throws SystemError when it cannot be made.
  explicit NewFolder(std::filesystem::path target);
  /// Removes everything that was not kept.
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  /// Throws SystemError when it cannot be written.
  void write(const std::string& name, std::string_view text) const;
  /// Gives it its name; a folder that has the name is removed. Throws SystemError when it cannot be renamed.
  void keep();

 private:
  std::filesystem::path target_, path_;
};

}  // namespace mrroc::cli
