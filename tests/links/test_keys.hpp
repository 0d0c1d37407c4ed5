#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli/key_maker.hpp"

namespace mrroc::links {

/// Keys of a deployment in a folder that goes with this object.
class TestKeys {
 public:
  explicit TestKeys(const std::string& deployment) {
    std::string pattern = (std::filesystem::temp_directory_path() / "mrroc_keys_XXXXXX").string();
    parent_ = ::mkdtemp(pattern.data());
    cli::make_keys(folder(), deployment);
  }
  ~TestKeys() { std::filesystem::remove_all(parent_); }
  TestKeys(const TestKeys&) = delete;
  TestKeys& operator=(const TestKeys&) = delete;

  std::filesystem::path folder() const { return parent_ / "keys"; }

 private:
  std::filesystem::path parent_;
};

}  // namespace mrroc::links
