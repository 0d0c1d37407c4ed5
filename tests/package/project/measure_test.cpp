#include <mrroc/testing.hpp>

using Measure = mrroc::task_test::DeploymentTest;

TEST_F(Measure, Succeeds) {
  const auto run = deployment("measure.toml").run();
  EXPECT_EQ(run.exit_code, 0) << run.output;
  expect_safe(run);
}

TEST_F(Measure, StopsWhenItsMpDies) {
  const auto run = deployment("measure.toml").inject("kill mp at step 5").run();
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_NE(run.error.find("process mp died"), std::string::npos) << run.output;
  expect_safe(run);
}
