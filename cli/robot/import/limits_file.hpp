#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mrroc::cli {

/// A number with its source, as the comment of a parameter file states it: "URDF line 12", "given", "guessed: ...".
struct SourcedNumber {
  double value = 0;
  std::string source;
};

/// The limits that a user gives to `mrroc robot add --limits FILE`: TOML with `[all]`, for every axis, and
/// `[axes.NAME]`. Configuration time only.
class LimitsFile {
 public:
  /// No limits.
  LimitsFile() = default;
  /// Throws config::ConfigurationError: unreadable, an unknown key, a limit that is not a positive number, a
  /// position_min that is not below position_max.
  static LimitsFile load(const std::filesystem::path& file);

  /// Throws config::ConfigurationError when the name of an `[axes.NAME]` is not among `names`.
  void check_names(const std::vector<std::string>& names) const;

  /// The limit `key` of an axis; nothing when it is not given.
  std::optional<SourcedNumber> find(const std::string& axis, const std::string& key) const;

 private:
  using Limits = std::map<std::string, SourcedNumber>;
  std::filesystem::path file_;
  Limits all_;
  std::map<std::string, Limits> axes_;
  std::map<std::string, int> lines_;  // of the axes
};

}  // namespace mrroc::cli
