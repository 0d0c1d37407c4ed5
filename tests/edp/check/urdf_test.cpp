#include "edp/check/urdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numbers>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::edp::urdf_test {
namespace {

using std::numbers::pi;

/// A crane: a mast that turns, a boom that slides out of it, a counterweight that follows it, a hook.
const std::string kCrane = R"(<robot name="crane">
<link name="base"/>
<link name="mast"/>
<link name="boom"><inertial><mass value="3"/></inertial></link>
<link name="weight"/>
<link name="hook"/>
<joint name="turn" type="revolute">
  <parent link="base"/><child link="mast"/>
  <origin xyz="0 0 1" rpy="0 0 0"/><axis xyz="0 0 2"/>
  <limit lower="-1" upper="2" velocity="0.5" effort="1"/>
</joint>
<joint name="reach" type="prismatic">
  <parent link="mast"/><child link="boom"/>
  <origin xyz="0.5 0 0" rpy="1.5707963267948966 0 1.5707963267948966"/><axis xyz="0 0 1"/><limit effort="1" velocity="0.2"/>
</joint>
<joint name="back" type="prismatic">
  <parent link="mast"/><child link="weight"/>
  <mimic joint="reach" multiplier="-0.5" offset="-0.1"/><limit effort="1" velocity="0.2"/>
</joint>
<joint name="rope" type="fixed">
  <parent link="boom"/><child link="hook"/><origin xyz="0 -2 0"/>
</joint>
</robot>)";

/// kCrane with the first `from` replaced by `to`.
std::string crane(const std::string& from, const std::string& to) {
  std::string text = kCrane;
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + from);
  return text.replace(at, from.size(), to);
}

Urdf load(const std::string& text) {
  const task_test::ScratchFolder scratch;
  return Urdf::load(scratch.write("c.urdf", text));
}

std::string mistake(const std::string& text) {
  const task_test::ScratchFolder scratch;
  const auto file = scratch.write("c.urdf", text);
  return config::message_of(scratch.path(), [&] { Urdf::load(file); });
}

TEST(Urdf, ReadsItsJoints) {
  const Urdf urdf = load(kCrane);
  EXPECT_TRUE(urdf.has_link("weight"));
  EXPECT_FALSE(urdf.has_link("turn"));
  EXPECT_EQ(urdf.line_of_link("boom"), 4);
  const Urdf::Joint* turn = urdf.joint("turn");
  ASSERT_NE(turn, nullptr);
  EXPECT_EQ(turn->line, 7);
  EXPECT_EQ(turn->type, Urdf::Type::revolute);
  EXPECT_EQ(turn->axis, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(turn->lower, -1);
  EXPECT_EQ(turn->upper, 2);
  EXPECT_EQ(turn->velocity, 0.5);
  EXPECT_FALSE(turn->mimic);
  EXPECT_EQ(urdf.joint("reach")->lower, 0);
  EXPECT_EQ(urdf.joint("back")->axis, Eigen::Vector3d::UnitX()) << "the default axis";
  EXPECT_EQ(urdf.joint("boom"), nullptr);
  EXPECT_EQ(urdf.joint_above("hook")->name, "rope");
  EXPECT_EQ(urdf.joint_above("base"), nullptr);
}

TEST(Urdf, PlacesItsLinks) {
  const Urdf urdf = load(kCrane);
  const Urdf::Positions positions{{"turn", pi / 2}, {"reach", 0.25}};
  EXPECT_TRUE(urdf.pose("base", {}).isApprox(Pose::Identity()));
  // the boom's z axis points forward along the turned mast, its y axis up
  const Pose hook = urdf.pose("hook", positions);
  EXPECT_LT((hook.translation() - Eigen::Vector3d(0, 0.75, -1)).norm(), 1e-12) << hook.translation().transpose();
  EXPECT_LT((hook.linear().col(2) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((hook.linear().col(1) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((urdf.pose("weight", positions).translation() - Eigen::Vector3d(0, -0.225, 1)).norm(), 1e-12);
}

TEST(Urdf, RefusesAJointThatNothingMoves) {
  const task_test::ScratchFolder scratch;
  const Urdf urdf = Urdf::load(scratch.write("c.urdf", kCrane));
  EXPECT_EQ(config::message_of(scratch.path(),
                               [&] {
                                 urdf.pose("weight", {{"turn", 0.0}});
                               }),
            "c.urdf:16: joint 'back': its position is not determined, expected an axis of the robot, a joint that "
            "follows one, "
            "or a fixed one");
}

TEST(Urdf, MistakesNameFileLineAndElement) {
  EXPECT_EQ(mistake(crane("upper=\"2\"", "upper=\"far\"")),
            "c.urdf:10: <limit> upper: 'far' is not a number, expected a number");
  EXPECT_EQ(mistake(crane("upper=\"2\"", "upper=\"2 3\"")), "c.urdf:10: <limit> upper: '2 3', expected a number");
  EXPECT_EQ(mistake(crane("upper=\"2\"", "upper=\"nan\"")),
            "c.urdf:10: <limit> upper: 'nan' is not finite, expected a number");
  EXPECT_EQ(mistake(crane("0 0 1\" rpy", "0 1\" rpy")),
            "c.urdf:9: <origin> xyz: '0 1', expected 3 numbers with blanks between");
  EXPECT_EQ(mistake(crane("0 0 2", "0 0 0")), "c.urdf:9: <axis> xyz: no direction, expected a vector");
  EXPECT_EQ(mistake(crane("0 0 2", "0 0 1e200")), "c.urdf:9: <axis> xyz: no direction, expected a vector");
  EXPECT_EQ(mistake(crane("revolute", "floating")),
            "c.urdf:7: <joint> type: 'floating', expected 'fixed', 'revolute', 'continuous' or 'prismatic'");
  EXPECT_EQ(mistake(crane("<parent link=\"base\"/>", "")), "c.urdf:7: <joint>: no <parent>, expected one");
  EXPECT_EQ(mistake(crane("<parent link=\"base\"/>", "<parent/>")),
            "c.urdf:8: <parent> link: missing, expected a name");
  EXPECT_EQ(mistake(crane("child link=\"mast\"", "child link=\"mest\"")),
            "c.urdf:7: <joint> name='turn': no link 'mest', expected links of this file");
  EXPECT_EQ(mistake(crane("name=\"reach\"", "name=\"turn\"")),
            "c.urdf:12: <joint> name: 'turn' is the name of an earlier joint, expected a unique name");
  EXPECT_EQ(mistake(crane("<link name=\"mast\"/>", "<link name=\"base\"/>")),
            "c.urdf:3: <link> name: 'base' is the name of an earlier link, expected a unique name");
  EXPECT_EQ(mistake("<robot name=\"none\"/>"), "c.urdf:1: <robot>: no <link>, expected links");
}

TEST(Urdf, HasTheDefaultsOfItsSpecification) {
  const Urdf urdf = load(crane("lower=\"-1\" upper=\"2\" ", ""));
  EXPECT_EQ(urdf.joint("turn")->lower, 0);
  EXPECT_EQ(urdf.joint("turn")->upper, 0);
  EXPECT_EQ(load(crane("lower=\"-1\" ", "")).joint("turn")->lower, 0);
  EXPECT_EQ(load(crane("upper=\"2\" ", "")).joint("turn")->upper, 0);
  EXPECT_EQ(load(crane("<axis xyz=\"0 0 2\"/>", "")).joint("turn")->axis, Eigen::Vector3d::UnitX());
  EXPECT_EQ(load(crane("<axis xyz=\"0 0 2\"/>", "<axis/>")).joint("turn")->axis, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(
      load(crane("<origin xyz=\"0 0 1\" rpy=\"0 0 0\"/>", "")).joint("turn")->origin.isApprox(Pose::Identity()));
  EXPECT_EQ(load(crane(" multiplier=\"-0.5\" offset=\"-0.1\"", "")).joint("back")->mimic->multiplier, 1);
  EXPECT_EQ(load(crane(" multiplier=\"-0.5\" offset=\"-0.1\"", "")).joint("back")->mimic->offset, 0);
}

TEST(Urdf, IgnoresValuesThatTheJointTypeDoesNotUse) {
  for (const char* const more :
       {"<axis xyz='0 0 0'/>", "<axis xyz='none'/>", "<limit/>", "<limit lower='far' upper='nan'/>", "<mimic/>",
        "<dynamics damping='much'/>", "<limit effort='0' velocity='0'/><axis xyz='1e200 0 0'/>"}) {
    const Urdf urdf = load(crane("<origin xyz=\"0 -2 0\"/>", std::string("<origin xyz=\"0 -2 0\"/>") + more));
    EXPECT_FALSE(urdf.joint("rope")->lower || urdf.joint("rope")->mimic) << more;
  }
  for (const char* const limit :
       {"", "<limit effort='1' velocity='2' lower='far'/>", "<limit effort='1' velocity='2'/>"}) {
    std::string text = crane("type=\"revolute\"", "type=\"continuous\"");
    const std::string own = "<limit lower=\"-1\" upper=\"2\" velocity=\"0.5\" effort=\"1\"/>";
    text.replace(text.find(own), own.size(), limit);
    EXPECT_FALSE(load(text).joint("turn")->lower) << limit;
  }
  EXPECT_NO_THROW(load(crane("<link name=\"hook\"/>",
                             "<link name=\"hook\"/><gazebo><joint name='x'/></gazebo>"
                             "<transmission name='t'><joint name='turn'/></transmission>"
                             "<g:extra xmlns:g='u'/>")));
}

TEST(Urdf, HasOneRootAndMayEndAsOldEditorsEndAFile) {
  EXPECT_NO_THROW(load(kCrane + "\n\x1A"));
  EXPECT_NO_THROW(load(kCrane + "\n<!-- the end -->\n"));
  for (const char* const second : {"<robot name='other'/>", "<link name='base'/>"})
    EXPECT_NE(mistake(kCrane + "\n" + second).find("a second element outside of the first"), std::string::npos);
}

// what is not read would put a link elsewhere, or give a joint another range
TEST(Urdf, RefusesMisspeltAndSecondOnes) {
  for (const char* const word : {"ypr", "rxyz", "quat_xyzw"})
    EXPECT_NE(mistake(crane("0 0 1\" rpy", std::string("0 0 1\" ") + word))
                  .find(std::string("<origin> ") + word + ": is unknown"),
              std::string::npos)
        << word;
  EXPECT_NE(mistake(crane("<axis xyz=\"0 0 2\"/>", "<axis xzy=\"0 0 2\"/>")).find("<axis> xzy: is unknown"),
            std::string::npos);
  EXPECT_NO_THROW(load(crane("0 0 1\" rpy", "0 0 1\" my:note=\"x\" rpy")));
  for (const char* const element : {"<axis xyz='0 0 1'/>", "<origin xyz='0 0 2'/>", "<limit effort='1' velocity='1'/>"})
    EXPECT_NE(mistake(crane("<axis xyz=\"0 0 2\"/>", std::string("<axis xyz=\"0 0 2\"/>") + element))
                  .find("a second one, expected one"),
              std::string::npos)
        << element;
}

TEST(Urdf, MovingJointNeedsEffortAndVelocity) {
  EXPECT_EQ(mistake(crane("velocity=\"0.5\" ", "")), "c.urdf:10: <limit> velocity: missing, expected a number");
  EXPECT_EQ(mistake(crane("effort=\"1\"/>", "/>")), "c.urdf:10: <limit> effort: missing, expected a number");
  EXPECT_EQ(mistake(crane("<limit effort=\"1\" velocity=\"0.2\"/>", "")),
            "c.urdf:12: <joint> name='reach': no <limit>, expected one with effort and velocity");
}

TEST(Urdf, AcceptsManySpellingsOfNumbers) {
  for (const char* const good : {"1.e-3 0 0", "+1 0 0", " 1\n2\t3 ", ".5 -.5 1E3", "1e-400 0 0"})
    EXPECT_NO_THROW(load(crane("0 0 1\" rpy", std::string(good) + "\" rpy"))) << good;
  EXPECT_EQ(mistake(crane("0 0 1\" rpy", "1,0 0 0\" rpy")),
            "c.urdf:9: <origin> xyz: '1,0' has a decimal comma, expected 3 numbers with blanks between");
  EXPECT_EQ(mistake(crane("0 0 1\" rpy", "inf 0 0\" rpy")),
            "c.urdf:9: <origin> xyz: 'inf' is not finite, expected 3 numbers with blanks between");
  EXPECT_EQ(mistake(crane("0 0 1\" rpy", "0\xC2\xA0 0 0\" rpy")),
            "c.urdf:9: <origin> xyz: '0U+00A0' has U+00A0 at character 2, expected 3 numbers with blanks between");
  EXPECT_EQ(mistake(crane("0 0 1\" rpy", "${height} 0 0\" rpy")),
            "c.urdf:9: <origin> xyz: '${height} 0 0' is a xacro expression, expected the URDF that the command xacro "
            "makes of this file");
  EXPECT_EQ(
      mistake(crane("<link name=\"base\"/>", "<xacro:property xmlns:xacro='x' name='a' value='1'/>")),
      "c.urdf:2: <xacro:property>: is an element of xacro, expected the URDF that the command xacro makes of this "
      "file");
}

TEST(Urdf, AcceptsAdditionsOfEditors) {
  std::string crlf;
  for (const char c : kCrane) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& text :
       {"\xEF\xBB\xBF" + kCrane, crlf, "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!-- c -->\r\n" + crlf,
        "<!-- exported -->\n" + kCrane, kCrane + "\n<!-- end -->\n"})
    EXPECT_TRUE(load(text).has_link("hook"));
  for (const char* const before : {"<!-- exported -->", "<!-- exported -->\n\n", "<a/>", "<!-- <?xml ?> -->"}) {
    const std::string message = mistake(before + std::string("<?xml version='1.0'?>") + kCrane);
    const int line = 1 + static_cast<int>(std::count(before, before + std::strlen(before), '\n'));
    EXPECT_TRUE(message.starts_with("c.urdf:" + std::to_string(line) +
                                    ": the declaration <?xml ...?> is not at the "
                                    "beginning of the file"))
        << message;
  }
  EXPECT_NE(mistake("\xFF\xFE<").find("UTF-16"), std::string::npos);
  EXPECT_NE(mistake(kCrane + std::string(1, '\0')).find("\\x00"), std::string::npos);
}

TEST(Urdf, RefusesLinksThatAreNotATree) {
  EXPECT_EQ(mistake(crane("child link=\"weight\"", "child link=\"boom\"")),
            "c.urdf:16: <joint> name='back': link 'boom' has two parents, expected a tree");
  EXPECT_EQ(mistake(crane("<link name=\"hook\"/>", "<link name=\"hook\"/><link name=\"lost\"/>")),
            "c.urdf:1: <robot>: 6 links, 4 joints, expected one joint less than links: a tree");
  EXPECT_NE(mistake(crane("<parent link=\"base\"/>", "<parent link=\"hook\"/>")).find("is part of a ring"),
            std::string::npos);
}

TEST(Urdf, RefusesFilesThatAreNotUrdf) {
  EXPECT_EQ(mistake("<mujoco/>"), "c.urdf:1: is not a URDF, expected <robot>");
  EXPECT_NE(mistake("<robot><link name=\"a\"></robot>"), "");
  EXPECT_NE(mistake(""), "");
  const task_test::ScratchFolder scratch;
  EXPECT_NE(config::message_of(scratch.path(), [&] { Urdf::load(scratch.path() / "none.urdf"); }).find("none.urdf"),
            std::string::npos);
}

}  // namespace
}  // namespace mrroc::edp::urdf_test
