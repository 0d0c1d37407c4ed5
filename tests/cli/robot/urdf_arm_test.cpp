#include "cli/robot/urdf_arm.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <random>

#include "cli/robot/type/show_arm.hpp"
#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::urdf_arm_test {
namespace {

using edp::Urdf;

const std::filesystem::path kRobots = MRROC_SOURCE_DIR "/robots";

/// A joint between two links, with the limits that the type needs.
std::string joint(const std::string& name, const std::string& type, const std::string& parent, const std::string& child,
                  const std::string& more = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child +
         "'/><origin xyz='0.1 0 0.2' rpy='0.1 0.2 0.3'/><axis xyz='0 1 1'/>"
         "<limit lower='-1' upper='1' effort='1' velocity='1'/>" +
         more + "</joint>\n";
}

std::string links(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += "<link name='" + name + "'/>\n";
  return text;
}

class UrdfArmTest : public testing::Test {
 protected:
  Urdf read(const std::string& elements) {
    return Urdf::load(folder_.write("arm.urdf", "<robot name='r'>\n" + elements + "</robot>\n"));
  }
  std::string message(const std::string& elements, const std::string& base = "", const std::string& tip = "") {
    try {
      arm_of(read(elements), base, tip);
    } catch (const config::ConfigurationError& error) {
      const std::string text = error.what();
      return text.substr(text.find("arm.urdf"));
    }
    return "";
  }
  task_test::ScratchFolder folder_;
};

/// The same chain by KDL, from the same joints one by one.
TEST_F(UrdfArmTest, AgreesWithKdl) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  for (const auto& [type, tip] : {std::pair{"irb6", "flange"}, {"irb60", "flange"}, {"irb6_track", "flange"}}) {
    const Urdf urdf = Urdf::load(kRobots / type / (std::string{type} + ".urdf"));
    const UrdfArm arm = arm_of(urdf, "", tip);
    KDL::Chain chain;
    std::vector<const Urdf::Joint*> path;
    for (const Urdf::Joint* up = urdf.joint_above(tip); up != nullptr; up = urdf.joint_above(up->parent))
      path.insert(path.begin(), up);
    for (const Urdf::Joint* each : path) {
      const auto& r = each->origin.linear();
      const KDL::Frame origin(
          KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          KDL::Vector(each->origin.translation().x(), each->origin.translation().y(), each->origin.translation().z()));
      const KDL::Vector axis = origin.M * KDL::Vector(each->axis.x(), each->axis.y(), each->axis.z());
      const bool fixed = each->type == Urdf::Type::fixed;
      const KDL::Joint::JointType kind =
          each->type == Urdf::Type::prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
      chain.addSegment(KDL::Segment(
          fixed ? KDL::Joint(each->name, KDL::Joint::Fixed) : KDL::Joint(each->name, origin.p, axis, kind), origin));
    }
    KDL::ChainFkSolverPos_recursive forward(chain);
    for (int round = 0; round < 1000; ++round) {
      KDL::JntArray joints(chain.getNrOfJoints());
      JointVector q(arm.chain.size());
      ASSERT_EQ(static_cast<int>(chain.getNrOfJoints()), arm.chain.size());
      for (int i = 0; i < q.size(); ++i)
        q[i] = joints(static_cast<unsigned>(i)) = std::uniform_real_distribution(-3.0, 3.0)(random);
      KDL::Frame there;
      ASSERT_GE(forward.JntToCart(joints, there), 0);
      const Pose pose = arm.chain.flange(q);
      for (int i = 0; i < 3; ++i) {
        ASSERT_NEAR(pose.translation()[i], there.p[i], 1e-9);
        for (int j = 0; j < 3; ++j) ASSERT_NEAR(pose.linear()(i, j), there.M(i, j), 1e-9);
      }
    }
  }
}

TEST_F(UrdfArmTest, EndsAtTheLongestArm) {
  const UrdfArm arm = arm_of(read(links({"base", "a", "b", "camera", "end"}) + joint("j1", "revolute", "base", "a") +
                                  joint("j2", "prismatic", "a", "b") + joint("mount", "fixed", "a", "camera") +
                                  joint("f", "fixed", "b", "end")),
                             "", "");
  EXPECT_EQ(arm.base, "base");
  EXPECT_EQ(arm.tip, "end");
  ASSERT_EQ(arm.axes.size(), 2U);
  EXPECT_TRUE(arm.chain.slides(1));
}

TEST_F(UrdfArmTest, RefusesWhatIsNoArm) {
  const std::string two = links({"base", "a", "left", "right"}) + joint("j1", "revolute", "base", "a") +
                          joint("j2", "revolute", "a", "left") + joint("j3", "revolute", "a", "right");
  EXPECT_EQ(message(two),
            "arm.urdf: --tip: is missing: several links are at the end of 2 axes, expected 'left' or 'right'");
  EXPECT_EQ(message(two, "", "lef"), "arm.urdf: --tip: no link 'lef', expected perhaps 'left'");
  EXPECT_EQ(message(two, "bse", "left"), "arm.urdf: --base: no link 'bse', expected perhaps 'base'");
  EXPECT_EQ(message(two, "right", "left"),
            "arm.urdf:4: link 'left': 0 moving joints between it and link 'right', expected 1 to 8");
  EXPECT_EQ(message(links({"base", "a", "b"}) + joint("j1", "revolute", "base", "a") +
                        joint("j2", "revolute", "a", "b", "<mimic joint='j1'/>"),
                    "", "b"),
            "arm.urdf:6: joint 'j2': follows joint 'j1' and is between base and tip, expected a tip before it");
  std::string names, chain;
  std::vector<std::string> many;
  for (int i = 0; i <= 9; ++i) many.push_back("l" + std::to_string(i));
  for (int i = 0; i < 9; ++i)
    chain += joint("j" + std::to_string(i), "revolute", many[static_cast<std::size_t>(i)],
                   many[static_cast<std::size_t>(i) + 1]);
  EXPECT_EQ(message(links(many) + chain),
            "arm.urdf:11: link 'l9': 9 moving joints between it and link 'l0', expected 1 to 8");
}

/// The IRb-6 has a wrist whose axes meet behind parallel ones; its own limits are those of the report.
TEST(ShowArm, NamesStructureReachAndSingularities) {
  ShowRequest request;
  request.arm = kRobots / "irb6/irb6.urdf";
  request.tip = "flange";
  request.postures = 200;
  const std::string report = show_arm(request);
  std::printf("%s", report.c_str());
  EXPECT_NE(report.find("6 axes from link "), std::string::npos);
  EXPECT_NE(report.find("singular                     with wrist_roll at "), std::string::npos);
  EXPECT_NE(report.find("200 of 200 random poses within the limits are found"), std::string::npos);
  EXPECT_EQ(report, show_arm(request));
}

}  // namespace
}  // namespace mrroc::cli::urdf_arm_test
