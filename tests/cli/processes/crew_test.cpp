#include "cli/processes/crew.hpp"

#include <gtest/gtest.h>
#include <signal.h>

namespace mrroc::cli {
namespace {

PlannedProcess shell(const std::string& name) {
  PlannedProcess process;
  process.name = name;
  process.program = "/bin/sh";
  return process;
}

TEST(Crew, NamesTheSuspectAmongEndedProcesses) {
  Crew crew([](const std::string&, const std::string&) {});
  for (const char* name : {"first", "struck", "last"}) crew.start(shell(name), {"-c", "exec sleep 60"});
  EXPECT_EQ(crew.first_lost({"struck"}), nullptr) << "all are running";
  crew.signal(SIGKILL);
  while (!crew.all_ended()) crew.wait(1, -1);
  EXPECT_EQ(crew.first_lost({"struck", "nobody"})->name(), "struck");
  EXPECT_EQ(crew.first_lost()->name(), "first");
  EXPECT_EQ(crew.first_lost({"nobody"})->name(), "first");
}

TEST(Crew, NamesAnotherWhileTheSuspectRuns) {
  Crew crew([](const std::string&, const std::string&) {});
  crew.start(shell("suspect"), {"-c", "exec sleep 60"});
  crew.start(shell("other"), {"-c", "exit 3"});
  Child* lost = nullptr;
  while ((lost = crew.first_lost({"suspect"})) == nullptr) crew.wait(1, -1);
  EXPECT_EQ(lost->name(), "other");
  crew.signal(SIGKILL);
}

}  // namespace
}  // namespace mrroc::cli
