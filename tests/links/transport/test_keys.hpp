#pragma once

#include <filesystem>
#include <string>

#include "cli/keys/key_maker.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::links {

/// Keys of a deployment in a folder that is removed with this object.
class TestKeys {
 public:
  explicit TestKeys(const std::string& deployment) { cli::make_keys(folder(), deployment); }

  std::filesystem::path folder() const { return parent_ / "keys"; }

 private:
  task_test::ScratchFolder parent_;
};

}  // namespace mrroc::links
