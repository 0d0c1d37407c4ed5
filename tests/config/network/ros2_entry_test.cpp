#include "config/network/ros2_entry.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <string>

#include "config/message_of.hpp"

namespace mrroc::config::ros2_entry_test {
namespace {

std::optional<Ros2Entry> read(const std::string& text) { return read_ros2(Table::parse("d.toml", text)); }

std::string error_of(const std::string& line) {
  return message_of("", [&] { read("[ros2]\n" + line + "\n"); });
}

TEST(Ros2Entry, IsNotThereWithoutItsTable) { EXPECT_FALSE(read("[deployment]\nname = 'one'\n")); }

TEST(Ros2Entry, OnlyWatchesUnlessItIsAllowedMore) {
  const auto entry = read("[ros2]\n");
  ASSERT_TRUE(entry);
  EXPECT_FALSE(entry->domain);
  EXPECT_EQ(entry->distro, "jazzy");
  EXPECT_EQ(entry->name_space, "/");
  EXPECT_EQ(entry->interface, "");
  EXPECT_FALSE(entry->commands);
}

TEST(Ros2Entry, ReadsItsKeys) {
  const auto entry =
      read("[ros2]\ndomain = 230\ndistro = 'humble'\nnamespace = '/lab/cell_2'\ninterface = 'lo'\ncommands = true\n");
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->domain, 230);
  EXPECT_EQ(entry->distro, "humble");
  EXPECT_EQ(entry->name_space, "/lab/cell_2");
  EXPECT_EQ(entry->interface, "lo");
  EXPECT_TRUE(entry->commands);
}

TEST(Ros2Entry, RefusesWhatRos2DoesNotAccept) {
  EXPECT_EQ(error_of("distro = 'foxy'"),
            "d.toml:2: ros2.distro: 'foxy', expected humble, iron, jazzy, kilted, lyrical or rolling");
  for (const char* name : {"", "lab", "/lab/", "//lab", "/2lab", "/la b", "/lab-2"})
    EXPECT_EQ(error_of("namespace = '" + std::string(name) + "'"),
              "d.toml:2: ros2.namespace: '" + std::string(name) +
                  "', expected \"/\", or names of letters, digits and _, each behind a /: \"/lab/cell\"");
  for (const char* line :
       {"domain = 231", "domain = -1", "domain = '0'", "interface = 'a/b'", "commands = 1", "topic = 'x'"})
    EXPECT_TRUE(error_of(line).starts_with("d.toml:2: ros2.")) << line << ": " << error_of(line);
}

TEST(Ros2Entry, ItsDomainIsThatOfAnyNodeUnlessItIsGiven) {
  const char* const name = "ROS_DOMAIN_ID";
  unsetenv(name);
  EXPECT_EQ(ros2_domain({}), 0);
  setenv(name, "42", 1);
  EXPECT_EQ(ros2_domain({}), 42);
  Ros2Entry given;
  given.domain = 3;
  EXPECT_EQ(ros2_domain(given), 3);
  for (const char* bad : {"231", "-1", "4 2", "x", "99999999999"}) {
    setenv(name, bad, 1);
    EXPECT_THROW(ros2_domain({}), std::runtime_error) << bad;
  }
  unsetenv(name);
}

}  // namespace
}  // namespace mrroc::config::ros2_entry_test
