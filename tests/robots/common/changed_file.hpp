#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "text_of.hpp"

namespace mrroc {

/// Text of `file` with the first `from` replaced by `to`; throws when `from` is missing.
inline std::string changed_file(const std::filesystem::path& file, const std::string& from, const std::string& to) {
  std::string text = test::text_of(file);
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no \"" + from + "\" in " + file.string());
  return text.replace(at, from.size(), to);
}

/// The error of `load` for `file` with `from` replaced by `to`; empty: it loads.
template <class Load>
std::string error_of_changed(Load load, const std::filesystem::path& file, const std::string& from,
                             const std::string& to) {
  const task_test::ScratchFolder folder;
  const auto changed = folder.write(file.filename().string(), changed_file(file, from, to));
  try {
    load(changed);
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
  return "";
}

inline testing::AssertionResult names(const std::string& error, const std::string& key) {
  if (error.find(key) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << error << "\" does not name " << key;
}

}  // namespace mrroc
