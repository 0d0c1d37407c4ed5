#include "config/entries/errors_entry.hpp"

#include <gtest/gtest.h>

#include <string_view>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::errors_entry_test {
namespace {

TEST(ErrorsEntry, KeysOverrideTheSetBesideTheDeployment) {
  const task_test::ScratchFolder folder;
  folder.write("lab.toml", "backlash = 0.001\nfriction = 0.02\n");
  const std::string text = "set = './lab.toml'\nseed = 7\nfriction = 0.1\n";
  const ErrorsEntry errors = read_errors(Table::parse(folder.path() / "cell.toml", text));
  EXPECT_EQ(errors.seed, 7U);
  EXPECT_EQ(errors.backlash, 0.001);
  EXPECT_EQ(errors.friction, 0.1);
  EXPECT_EQ(errors.base_position, 0);
}

TEST(ErrorsEntry, ModestSetHasEverySize) {
  const task_test::ScratchFolder folder;
  const std::string text = "set = '" MRROC_SOURCE_DIR "/sim/errors/sets/modest.toml'\n";
  const ErrorsEntry errors = read_errors(Table::parse(folder.path() / "cell.toml", text));
  for (const ErrorKey& key : error_keys()) {
    if (std::string_view(key.name) == "shadow") continue;  // of hard lamps only: the laboratory's light is diffuse
    EXPECT_GT(errors.*key.size, 0) << key.name;
  }
}

TEST(ErrorsEntry, WithoutKeysThereAreNoErrors) {
  const ErrorsEntry errors = read_errors(Table::parse("cell.toml", ""));
  for (const ErrorKey& key : error_keys()) EXPECT_EQ(errors.*key.size, 0) << key.name;
}

}  // namespace
}  // namespace mrroc::config::errors_entry_test
