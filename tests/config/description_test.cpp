#include "config/description.hpp"

#include "config/deployment_fixture.hpp"

namespace mrroc::config::description_test {
namespace {

class DescriptionTest : public DeploymentFixture {
 protected:
  DescriptionTest() : DeploymentFixture("valid") {}

  std::string description(const std::string& file) const {
    const std::string text = describe(load_deployment(file));
    return replaced(replaced(text, programs_.path().string(), "PROGRAMS"), MRROC_SOURCE_DIR, "SOURCE");
  }
};

TEST_F(DescriptionTest, ListsEveryProcessWithItsProgram) {
  EXPECT_EQ(description("full.toml"),
            "press_2: paced, servo period 0.001 s, DDS domain 17\n"
            "  mp     PROGRAMS/press_mp\n"
            "  sim    PROGRAMS/mrroc_sim, scene SOURCE/tests/config/valid/scene.xml, time step 0.0005 s\n"
            "  left   irb6 on mujoco: ECP PROGRAMS/press_ecp, EDP PROGRAMS/irb6_edp\n"
            "  belt   conveyor carried by left on loopback: ECP PROGRAMS/mrroc_ecp, EDP PROGRAMS/conveyor_edp\n"
            "  wrist  force_torque on left, interactive, simulated: VSP PROGRAMS/force_torque_vsp\n"
            "  gate   ultrasonic, non-interactive at 333.3333333333333 Hz, replay of "
            "SOURCE/tests/config/valid/readings.txt: VSP PROGRAMS/ultrasonic_vsp\n");
}

TEST_F(DescriptionTest, OmitsAbsentParts) {
  EXPECT_EQ(description("minimal.toml"),
            "one: lockstep, servo period 0.002 s, any free DDS domain\n"
            "  mp   PROGRAMS/mrroc_mp\n"
            "  arm  irb6 on loopback: ECP PROGRAMS/mrroc_ecp, EDP PROGRAMS/irb6_edp\n");
}

}  // namespace
}  // namespace mrroc::config::description_test
