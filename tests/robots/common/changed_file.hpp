#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "text_of.hpp"

namespace mrroc {

/// Text of `file` with the first `from` replaced by `to`; throws when `from` is missing.
inline std::string changed_file(const std::filesystem::path& file, const std::string& from, const std::string& to) {
  std::string text = test::text_of(file);
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in " + file.string());
  return text.replace(at, from.size(), to);
}

}  // namespace mrroc
