#include "cli/processes/process_group.hpp"

#include <gtest/gtest.h>
#include <signal.h>

namespace mrroc::cli::process_group_test {
namespace {

PlannedProcess shell(const std::string& name) {
  PlannedProcess process;
  process.name = name;
  process.program = "/bin/sh";
  return process;
}

TEST(ProcessGroup, NamesTheSuspectAmongEndedProcesses) {
  ProcessGroup group([](const std::string&, const std::string&) {});
  for (const char* name : {"first", "struck", "last"}) group.start(shell(name), {"-c", "exec sleep 60"});
  EXPECT_EQ(group.first_lost({"struck"}), nullptr) << "all are running";
  group.signal(SIGKILL);
  while (!group.all_ended()) group.wait(1, -1);
  EXPECT_EQ(group.first_lost({"struck", "nobody"})->name(), "struck");
  EXPECT_EQ(group.first_lost()->name(), "first");
  EXPECT_EQ(group.first_lost({"nobody"})->name(), "first");
}

TEST(ProcessGroup, NamesAnotherWhileTheSuspectRuns) {
  ProcessGroup group([](const std::string&, const std::string&) {});
  group.start(shell("suspect"), {"-c", "exec sleep 60"});
  group.start(shell("other"), {"-c", "exit 3"});
  Child* lost = nullptr;
  while ((lost = group.first_lost({"suspect"})) == nullptr) group.wait(1, -1);
  EXPECT_EQ(lost->name(), "other");
  group.signal(SIGKILL);
}

}  // namespace
}  // namespace mrroc::cli::process_group_test
