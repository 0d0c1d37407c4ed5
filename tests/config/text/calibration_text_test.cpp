#include "config/text/calibration_text.hpp"

#include "config/deployment_fixture.hpp"
#include "config/table.hpp"

namespace mrroc::config::calibration_text_test {
namespace {

class CalibrationText : public DeploymentFixture {
 protected:
  CalibrationText() : DeploymentFixture("valid") {}

  static std::string cell(const std::string& general) {
    return "[deployment]\nname = 'cell'\n" + general +
           "[robots.second]\ntype = 'irb6'\nhardware = 'loopback'\n"
           "[robots.arm]\ntype = 'irb6'\nhardware = 'loopback'\nprogram = 'press_ecp'\n"
           "[sensors.wrist]\ntype = 'force_torque'\nrobot = 'arm'\nsource = 'replay'\nreplay = 'wrist.txt'\n"
           "frozen_after = 0.125\nmode = 'polled'\n[[events]]\ntick = 3\ncommand = 'pause'\n";
  }
  /// The deployment with a calibration file of this content.
  Deployment calibrated(const std::string& content) {
    scratch_.write("wrist.txt", "");
    scratch_.write("wrist.toml", content);
    return load_deployment(scratch_.write("cell.toml", cell("calibration = ['wrist.toml']\n")));
  }
  std::string refusal(const std::string& content) {
    try {
      calibrated(content);
      return "";
    } catch (const ConfigurationError& error) {
      return error.what();
    }
  }
  task_test::ScratchFolder scratch_;
};

TEST_F(CalibrationText, KeysOfTheFileReplaceTheDeployments) {
  const Deployment deployment =
      calibrated("[sensors.wrist]\nfrozen_after = 1e-7\n[robots.arm]\nposition = [0.1, 0.2, 0.3]\n");
  const SensorEntry& wrist = deployment.sensor("wrist");
  EXPECT_EQ(wrist.frozen_after, 1e-7);
  EXPECT_TRUE(wrist.polled) << "a key that the file does not give stays";
  EXPECT_EQ(deployment.robot("arm").base.translation(), Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(deployment.robots.front().name, "second") << "in file order";
  EXPECT_EQ(deployment.file.filename(), "cell.toml");
  EXPECT_EQ(deployment.calibrations, std::vector<std::filesystem::path>{scratch_.path() / "wrist.toml"});
}

TEST_F(CalibrationText, IsReadOnce) {
  calibrated("[sensors.wrist]\nfrozen_after = 1e-7\n");
  const auto file = scratch_.path() / "cell.toml";
  const std::string text = with_calibrations(file, cell("calibration = ['wrist.toml']\n"));
  scratch_.write("wrist.toml", "[sensors.wrist]\nfrozen_after = 3\n");
  EXPECT_EQ(load_deployment(file, text).sensor("wrist").frozen_after, 1e-7) << "processes that read the text later";
  EXPECT_EQ(with_calibrations(file, text), text);
}

TEST_F(CalibrationText, TextWithoutTheKeyStaysAsItIs) {
  EXPECT_EQ(with_calibrations("cell.toml", cell("")), cell(""));
  EXPECT_EQ(with_calibrations("cell.toml", "[broken"), "[broken") << "its reader reports the mistake";
}

TEST_F(CalibrationText, MistakesAreNamedWithFileAndKey) {
  EXPECT_NE(refusal("[sensors.wirst]\nfrozen_after = 1\n")
                .find("wrist.toml:1: sensors.wirst: is not in the deployment, "
                      "expected 'wrist'"),
            std::string::npos);
  EXPECT_NE(refusal("[sim]\nscene = 'a.xml'\n").find("wrist.toml:1: sim: unknown key"), std::string::npos);
  const auto expect_at = [this](const std::string& content, const std::string& place) {
    const std::string text = refusal(content);
    EXPECT_NE(text.find("wrist.toml:" + place), std::string::npos) << text;
  };
  expect_at("[sensors.wrist]\nfrozen_afer = 1\n", "2: sensors.wrist.frozen_afer: unknown key");
  expect_at("[sensors.wrist]\nfrozen_after = 1\n\n[robots.arm]\nposition = [1, 2]\n", "5: robots.arm.position: has 2 ");
  expect_at("[robots.arm]\njoint_zeros = [\n  0.3,\n]\n", "2: robots.arm.joint_zeros[0]: 0.3 is out of range");
  expect_at("robots.arm.base_rotation = [0, 0, 0]\n", "1: robots.arm.base_rotation: alone");
  // what is wrong between two of its keys and the deployment is said of the first
  expect_at("[robots.arm]\nbase_position = [0, 0, 0]\n", "2: robots.arm.base_position: alone");
  try {
    load_deployment(scratch_.write("cell.toml", cell("calibration = ['none.toml']\n")));
    ADD_FAILURE() << "a missing file is accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("cell.toml:3: deployment.calibration: no file"), std::string::npos)
        << error.what();
  }
}

TEST_F(CalibrationText, CalibrationHasItsOwnTaskAndTheDeploymentsDevices) {
  scratch_.write("wrist.txt", "");
  const auto states = scratch_.write("states.toml", "");
  const std::string text = for_calibration(cell(""), {"arm", "press_ecp", states, "wrist", {{"mode", "interactive"}}});
  const Deployment deployment = load_deployment(scratch_.path() / "cell.toml", text);
  EXPECT_EQ(deployment.mp.states, states);
  EXPECT_EQ(std::filesystem::path(deployment.robot("arm").program).filename(), "press_ecp");
  EXPECT_EQ(std::filesystem::path(deployment.robot("second").program).filename(), "mrroc_ecp");
  EXPECT_FALSE(deployment.sensor("wrist").polled);
  EXPECT_TRUE(deployment.events.empty());
}

}  // namespace
}  // namespace mrroc::config::calibration_text_test
