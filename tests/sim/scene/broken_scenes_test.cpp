#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <ostream>

#include "sim/worlds.hpp"

namespace mrroc::sim::broken_scenes_test {
namespace {

using config::message_of;
using task_test::ScratchFolder;

constexpr const char* kRobot = R"(<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <body name="link">
      <joint name="j"/>
      <geom size="0.1"/>
    </body>
  </worldbody>
</mujoco>)";

struct Broken {
  const char* what;
  const char* scene;     ///< text in the scene from its line 3 on
  const char* place;     ///< beginning of the message
  const char* contains;  ///< of the message
};

std::ostream& operator<<(std::ostream& out, const Broken& broken) { return out << broken.what; }

class BrokenScene : public testing::TestWithParam<Broken> {};

// closed stdin: MuJoCo's own error handler would wait for a key
void close_stdin() {
  const int none = open("/dev/null", O_RDONLY);
  dup2(none, STDIN_FILENO);
  close(none);
}

TEST_P(BrokenScene, IsRefusedWithFileLineAndMujocosMessage) {
  close_stdin();
  const ScratchFolder scratch;
  const std::string scene = std::string("<mujoco>\n  <compiler angle='radian'/>\n") + GetParam().scene + "\n</mujoco>";
  const std::string message = message_of(scratch.path(), [&] {
    load_model(compose_texts(scratch, scene, {{"arm", kRobot}}));
  });
  EXPECT_TRUE(message.starts_with(GetParam().place)) << message;
  EXPECT_NE(message.find(GetParam().contains), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  // the line of the composed text would be misleading
  EXPECT_EQ(message.find(" line "), std::string::npos) << message;
  EXPECT_EQ(message.find("column"), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    , BrokenScene,
    testing::Values(
        Broken{"unknown_attribute", "<worldbody>\n<geom size='1' colour='red'/></worldbody>",
               "scene.xml:4: ", "unrecognized attribute: 'colour'"},
        Broken{"unknown_element", "<worldbody>\n\n<goem size='1'/></worldbody>", "scene.xml:5: ", "goem"},
        Broken{"not_closed", "<worldbody>\n<geom size='1'></worldbody>",
               "scene.xml:4: ", "the end tag of an element is missing or has another name"},
        Broken{"repeated_name", "<worldbody>\n<geom name='g' size='1'/>\n<geom name='g' size='1'/></worldbody>",
               "scene.xml:5: ", "repeated name"},
        Broken{"name_of_a_robot", "<worldbody>\n<body name='arm'/></worldbody>",
               "scene.xml:4: body: ", "repeated name 'arm', which robot 'arm' has in arm.xml:1"},
        Broken{"body_of_a_robot", "<worldbody>\n<body><body name='arm/link'/></body></worldbody>",
               "scene.xml:4: body: ", "repeated name 'arm/link', which robot 'arm' has in arm.xml:4"},
        Broken{"joint_of_a_robot", "<worldbody><body>\n<freejoint name='arm/j'/><geom size='1'/></body></worldbody>",
               "scene.xml:4: joint: ", "repeated name 'arm/j', which robot 'arm' has in arm.xml:5"},
        Broken{"repeated_mesh", "<asset>\n<mesh name='m' file='a.stl'/>\n<mesh name='m' file='b.stl'/></asset>",
               "scene.xml:5: mesh: ", "repeated name 'm', the first is in scene.xml:4"},
        Broken{"repeated_sensor", "<sensor>\n<clock name='t'/>\n<clock name='t'/></sensor>",
               "scene.xml:5: sensor: ", "repeated name 't', the first is in scene.xml:4"},
        Broken{"repeated_body", "<worldbody>\n<body name='b'/>\n<body><body name='b'/></body></worldbody>",
               "scene.xml:5: body: ", "repeated name 'b', the first is in scene.xml:4"},
        Broken{"repeated_class", "<default>\n<default class='c'/>\n<default class='c'/></default>", "scene.xml:", "c"},
        Broken{"decimal_comma", "<worldbody>\n<geom size='0,5'/></worldbody>",
               "scene.xml:4: geom.size: ", "0,5 has a decimal comma"},
        Broken{"late_declaration", "<!-- exported -->\n<?xml version='1.0'?>",
               "scene.xml:4: ", "beginning of the file"},
        Broken{"missing_mesh", "<asset>\n<mesh file='none.stl'/></asset>", "scene.xml:4: ", "none.stl"},
        Broken{"unknown_material", "<worldbody>\n<geom size='1' material='gold'/></worldbody>",
               "scene.xml:4: ", "gold"},
        Broken{"missing_include", "\n<include file='none.xml'/>", "scene.xml:4: ", "none.xml"},
        Broken{"reversed_range",
               "<worldbody><body>\n<joint limited='true' range='1 -1'/>\n<geom size='1'/></body></worldbody>",
               "scene.xml:4: ", "range[0] should be smaller than range[1]"},
        Broken{"letters_for_numbers", "<worldbody>\n<geom size='large'/></worldbody>",
               "scene.xml:4: ", "problem reading attribute 'size'"},
        Broken{"too_few_numbers", "<worldbody>\n<geom size='1' pos='1 2'/></worldbody>", "scene.xml:4: ", "pos"},
        Broken{"negative_size", "<worldbody>\n<geom size='-1'/></worldbody>",
               "scene.xml:4: ", "sizes must be positive"},
        Broken{"no_mass", "<worldbody>\n<body>\n<joint/></body></worldbody>", "scene.xml:4: ", "mass and inertia"},
        Broken{"sensor_without_site", "<sensor>\n<clock name='t'/>\n<rangefinder name='gate' site='none'/></sensor>",
               "scene.xml:5: ", "unrecognized name"},
        Broken{"weld_to_nothing", "<equality>\n<weld body1='arm/hand'/></equality>", "scene.xml:4: ", "arm/hand"},
        Broken{"unknown_class", "<worldbody>\n<geom class='none' size='1'/></worldbody>",
               "scene.xml:4: ", "unknown default class"},
        Broken{"world_with_attributes", "\n<worldbody name='w'/>", "scene.xml:4: ", "worldbody"},
        Broken{"not_a_number", "<worldbody>\n<geom size='nan'/></worldbody>", "scene.xml:4: geom.size", "nan"},
        Broken{"infinite_mass", "<worldbody><body>\n<freejoint/><geom size='1' mass='inf'/></body></worldbody>",
               "scene.xml:4: geom.mass", "inf"},
        Broken{"beyond_mujoco", "<worldbody>\n<body pos='1e300 0 0'/></worldbody>", "scene.xml:4: body.pos", "1e300"},
        Broken{
            "nested_free_joint",
            "<worldbody><body><joint/><geom size='1'/>\n<body><freejoint/><geom size='1'/></body></body></worldbody>",
            "scene.xml:4: ", "top level"},
        Broken{"small_stack", "<size nstack='10'/>", "scene.xml:1: ", "Stack overflow"}),
    [](const auto& test) { return test.param.what; });

std::string message_for_scene(const std::string& text) {
  const ScratchFolder scratch;
  return message_of(scratch.path(), [&] { load_model(compose_texts(scratch, text)); });
}

TEST(BrokenSceneFile, WithoutAnyElementOrOfAnotherKind) {
  close_stdin();
  EXPECT_TRUE(message_for_scene("").starts_with("scene.xml")) << message_for_scene("");
  EXPECT_TRUE(message_for_scene("no XML").starts_with("scene.xml")) << message_for_scene("no XML");
  EXPECT_EQ(message_for_scene("<robot name='urdf'/>"), "scene.xml:1: the root element is <robot>, expected <mujoco>");
}

TEST(BrokenSceneFile, NestedTooDeeply) {
  close_stdin();
  std::string text = "<mujoco><worldbody>";
  for (int i = 0; i < 2000; ++i) text += "<body>";
  for (int i = 0; i < 2000; ++i) text += "</body>";
  EXPECT_TRUE(message_for_scene(text + "</worldbody></mujoco>").starts_with("scene.xml:1: "));
}

TEST(BrokenSceneFile, ThatDoesNotExist) { EXPECT_THROW(compose("/none/scene.xml", {}), config::ConfigurationError); }

TEST(BrokenSceneFile, IncludingItself) {
  const ScratchFolder scratch;
  const auto scene = scratch.write("scene.xml", "<mujoco>\n<include file='scene.xml'/></mujoco>");
  EXPECT_EQ(message_of(scratch.path(), [&] { compose(scene, {}); }),
            "scene.xml:2: include: \"scene.xml\" is included a second time, expected each file once");
}

TEST(BrokenInclude, NamesTheIncludedFileAndItsLine) {
  const ScratchFolder scratch;
  scratch.write("objects.xml", "<mujoco>\n<worldbody>\n<geom size='-2'/></worldbody></mujoco>");
  const std::string message = message_of(
      scratch.path(), [&] { load_model(compose_texts(scratch, "<mujoco>\n<include file='objects.xml'/></mujoco>")); });
  EXPECT_TRUE(message.starts_with("objects.xml:3: MuJoCo: ")) << message;
}

TEST(BrokenRobot, NamesTheRobotsFileAndItsLine) {
  const ScratchFolder scratch;
  std::string robot = kRobot;
  robot.replace(robot.find("size=\"0.1\""), 10, "size=\"0\"");
  const std::string message = message_of(scratch.path(), [&] {
    load_model(compose_texts(scratch, kEmptyScene, {{"arm", robot}}));
  });
  EXPECT_TRUE(message.starts_with("robots/arm.xml:6: MuJoCo: ")) << message;
}

}  // namespace
}  // namespace mrroc::sim::broken_scenes_test
