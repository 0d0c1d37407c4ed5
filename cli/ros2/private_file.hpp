#pragma once

#include <filesystem>
#include <string_view>

namespace mrroc::cli {

/// A temporary file with a text that only this user may read, mode 0600; removed with the object.
class PrivateFile {
 public:
  /// In this folder, with a name that ends in `.toml`. Throws std::runtime_error with the path and the reason.
  PrivateFile(const std::filesystem::path& folder, std::string_view text);
  ~PrivateFile();
  PrivateFile(PrivateFile&& other) noexcept;
  PrivateFile& operator=(PrivateFile&&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace mrroc::cli
