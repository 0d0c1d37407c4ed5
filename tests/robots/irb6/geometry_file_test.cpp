#include <gtest/gtest.h>

#include "robots/irb6/family/changed_file.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc {
namespace {

const Loader kLoad = [](const std::filesystem::path& file) { return load_irb6(file); };

std::string error_with(const std::string& from, const std::string& to) { return error_with(kLoad, from, to); }

TEST(Irb6GeometryFile, ErrorsNameTheirKey) {
  EXPECT_EQ(error_with("lower_arm = 0.455", "lower_arm = 0.456"), "");
  EXPECT_NE(error_with("lower_arm = 0.455", "lower_arm = -1.0").find("geometry.lower_arm"), std::string::npos);
  EXPECT_NE(error_with("column_gear = -158.0", "column_gear = 0.0").find("geometry.column_gear"), std::string::npos);
  EXPECT_NE(error_with("squares = 0.07789525", "squares = 0.05").find("geometry.lower_arm_screw.squares"),
            std::string::npos);
  EXPECT_NE(error_with("wrist = 0.19", "wrest = 0.19").find("geometry.wrist"), std::string::npos);
  EXPECT_NE(error_with("synchro_length = 0.1838348", "").find("upper_arm_screw.synchro_length"), std::string::npos);
  EXPECT_NE(error_with("[geometry]", "[geometry]\nlenght = 1").find("lenght"), std::string::npos);
  EXPECT_NE(error_with("type = \"irb6\"", "type = \"irb6\"\ncolour = 1").find("colour"), std::string::npos);
}

TEST(Irb6GeometryFile, ErrorsInAModelNameTheirKey) {
  EXPECT_NE(error_with("lower_arm = 0.4596", "lower_arm = 99").find("models.calibrated.lower_arm"), std::string::npos);
  EXPECT_NE(error_with("column_offset = 0.0111", "colum_offset = 0.0111").find("models.calibrated.colum_offset"),
            std::string::npos);
  EXPECT_NE(error_with("synchro = [-7.7597, ", "synchro = [").find("models.calibrated.synchro"), std::string::npos);
  EXPECT_NE(error_with("squares = 0.0783794388", "squares = 0.01").find("models.calibrated.lower_arm_screw.squares"),
            std::string::npos);
  EXPECT_NE(error_with("[models.calibrated]", "[models.nominal]\n[models.calibrated]").find("models.nominal"),
            std::string::npos);
}

// the linkages are 0.101 m long at one dead centre and 0.381 m at the other
TEST(Irb6GeometryFile, RefusesAMotorThatReachesADeadCentreWithinItsLimits) {
  const std::string far = error_with("motor_max = 100.0", "motor_max = 250.0");
  EXPECT_NE(far.find("geometry.lower_arm_screw.synchro_length: the screw is 0.42"), std::string::npos) << far;
  EXPECT_NE(far.find("with the motor of axis 'lower_arm' at its limit, 250 rad, expected a length between the dead "
                     "centres of the linkage, 0.101"),
            std::string::npos)
      << far;
  EXPECT_NE(
      error_with("motor_min = -80.0", "motor_min = -inf").find("upper_arm_screw.synchro_length: the screw is -inf"),
      std::string::npos);
  EXPECT_NE(error_with("synchro = [-7.7597, -8.7537", "synchro = [-7.7597, -128.7537")
                .find("models.calibrated.lower_arm_screw.synchro_length"),
            std::string::npos);
}

TEST(Irb6GeometryFile, InstalledFileLoads) {
  const auto model = load_irb6().front();
  EXPECT_EQ(model->parameters().type, "irb6");
  EXPECT_EQ(model->joint_count(), 6);
  EXPECT_EQ(model->parameters().axes[3].name, "wrist_pitch");
}

TEST(Irb6GeometryFile, ToolRotationIsAboutFixedAxes) {
  const auto turned =
      load_with(kLoad, "tool_rotation = [0.0, 0.0, 0.0]", "tool_rotation = [1.5707963267948966, 0.0, 0.3]").front();
  const JointVector home = robot().parameters().home;
  const Pose change = arm().direct(home).inverse() * ToolKinematics(*turned).direct(home);
  EXPECT_LT(change.translation().norm(), 1e-12);
  EXPECT_LT((change.linear() * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((change.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d(std::cos(0.3), std::sin(0.3), 0)).norm(),
            1e-12);
}

}  // namespace
}  // namespace mrroc
