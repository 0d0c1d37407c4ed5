#include <gtest/gtest.h>

#include "config/deployment_fixture.hpp"
#include "config/entries/driver_entry.hpp"

namespace mrroc::config::stand_in_entry_test {
namespace {

class StandInEntryTest : public DeploymentFixture {
 protected:
  StandInEntryTest() : DeploymentFixture("valid") {
    scratch_.write("scene.xml", "");
    for (const char* const name : {"ur_controller", "netft_sensor"})
      std::filesystem::permissions(programs_.write(name, ""), std::filesystem::perms::owner_all);
  }

  /// An IRb-6 behind a UR controller with these keys, and its wrist sensor with these lines.
  Deployment load(const std::string& clock, const std::string& controller, const std::string& wrist) const {
    return load_deployment(scratch_.write(
        "cell/d.toml",
        "[deployment]\nname = 'one'\nclock = '" + clock +
            "'\n[sim]\nscene = '../scene.xml'\n[robots.arm]\ntype = 'irb6'\nhardware = 'ur'\nur = { address "
            "= '127.0.0.1'" +
            controller + " }\n[sensors.wrist]\ntype = 'force_torque'\nrobot = 'arm'\n" + wrist));
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(StandInEntryTest, StandInsWorkUnderEveryClock) {
  for (const char* const clock : {"real", "paced", "lockstep"})
    for (const char* const wrist :
         {"source = 'ur'\n", "source = 'netft'\nnetft = { address = '127.0.0.1', simulated = true }\n"}) {
      const Deployment deployment = load(clock, ", simulated = true", wrist);
      for (const ClockMode mode : {ClockMode::real, ClockMode::paced, ClockMode::lockstep}) {
        EXPECT_TRUE(works_under(deployment.robot("arm").driver, mode)) << clock;
        EXPECT_TRUE(works_under(*deployment.sensors.front().driver, mode)) << clock << " " << wrist;
      }
    }
}

TEST_F(StandInEntryTest, RealDevicesNeedTheRealClock) {
  const Deployment deployment = load("real", "", "source = 'ur'\n");
  EXPECT_TRUE(works_under(*deployment.sensors.front().driver, ClockMode::real));
  EXPECT_FALSE(works_under(*deployment.sensors.front().driver, ClockMode::lockstep));
  EXPECT_THROW(load("lockstep", "", "source = 'ur'\n"), ConfigurationError);
}

}  // namespace
}  // namespace mrroc::config::stand_in_entry_test
