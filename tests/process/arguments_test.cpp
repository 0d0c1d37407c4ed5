#include "process/arguments.hpp"

#include <gtest/gtest.h>

namespace mrroc::process::arguments_test {
namespace {

Arguments parse(const std::vector<std::string>& words) {
  std::vector<std::string> copies{"program"};
  copies.insert(copies.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : copies) argv.push_back(word.data());
  return parse_arguments(static_cast<int>(argv.size()), argv.data()).value();
}

TEST(Arguments, CommandLineReadsBack) {
  const Arguments arguments{"press.toml",
                            6,
                            "arm",
                            3,
                            4,
                            17,
                            9,
                            "left on Go x:number:8\nleft tells Here\n",
                            "boxes",
                            5,
                            12,
                            "shots",
                            "motion",
                            8,
                            {"kill ecp:arm at tick 5", "kill mp at tick 6"},
                            "eth1",
                            {"10.0.0.2", "lab-pc-2"},
                            "/etc/cell keys"};
  const Arguments read = parse(to_command_line(arguments));
  EXPECT_EQ(read.deployment, arguments.deployment);
  EXPECT_EQ(read.name, arguments.name);
  EXPECT_EQ(read.clock_fd, 3);
  EXPECT_EQ(read.world_fd, 4);
  EXPECT_EQ(read.picture_fd, 12);
  EXPECT_EQ(read.domain, 17);
  EXPECT_EQ(read.deployment_fd, 6);
  EXPECT_EQ(read.record_fd, 9);
  EXPECT_EQ(read.motion_fd, 8);
  EXPECT_EQ(read.behaviours, arguments.behaviours);
  EXPECT_EQ(read.black_box, arguments.black_box);
  EXPECT_EQ(read.black_box_fd, 5);
  EXPECT_EQ(read.snapshots, arguments.snapshots);
  EXPECT_EQ(read.motion, "motion");
  EXPECT_EQ(read.faults, arguments.faults);
  EXPECT_EQ(read.interface, "eth1");
  EXPECT_EQ(read.peers, arguments.peers);
  EXPECT_EQ(read.keys, arguments.keys);
  EXPECT_EQ(read.descriptors(), (std::vector<int>{3, 4, 5, 6, 8, 9, 12}));
}

TEST(Arguments, ProgramExplainsItsUsageWithoutTheRunner) {
  try {
    parse({});
    FAIL() << "parsed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("mrroc run FILE"), std::string::npos);
  }
}

}  // namespace
}  // namespace mrroc::process::arguments_test
