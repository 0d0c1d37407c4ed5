#include "config/entries/sensor_type.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::sensor_type_test {
namespace {

class SensorTypeTest : public testing::Test {
 protected:
  SensorTypeTest() { setenv("MRROC_SHARE", scratch_.path().c_str(), 1); }
  ~SensorTypeTest() override { unsetenv("MRROC_SHARE"); }

  /// The sensor of the keys `text` under the declarations `type_text`.
  SensorEntry read(const std::string& type_text, const std::string& text = "") {
    scratch_.write("sensors/sonar/sonar.toml", type_text);
    SensorEntry sensor;
    sensor.type = "sonar";
    const Table table = Table::load(scratch_.write("d.toml", text));
    read_sensor_type(table, sensor);
    table.finish();
    return sensor;
  }

  std::string message(const std::string& type_text, const std::string& text = "") {
    return message_of(scratch_.path(), [&] { read(type_text, text); });
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(SensorTypeTest, TypeMayHaveOtherTablesAndNoParameters) {
  const SensorEntry sensor = read("[other]\nkey = 1\n");
  EXPECT_TRUE(sensor.numbers.empty());
  EXPECT_TRUE(sensor.texts.empty());
}

TEST_F(SensorTypeTest, ValueReplacesTheDefault) {
  const std::string type = "[parameters.range]\nkind = 'number'\ndefault = 4\nunit = 'm'\ntext = 'how far'\n";
  EXPECT_EQ(read(type).numbers.at("range"), std::vector<double>{4});
  EXPECT_EQ(read(type, "range = 2.5").numbers.at("range"), std::vector<double>{2.5});
}

TEST_F(SensorTypeTest, KeyWithoutADefaultIsRequired) {
  EXPECT_EQ(message("[parameters.port]\nkind = 'text'\n"), "d.toml:1: port: missing, expected a text");
  EXPECT_EQ(message("[parameters.gain]\nkind = 'number'\nmin = 0\n"),
            "d.toml:1: gain: missing, expected a number of at least 0");
  EXPECT_EQ(message("[parameters.offset]\nkind = 'numbers'\nsize = 6\n"),
            "d.toml:1: offset: missing, expected an array of 6 numbers");
}

TEST_F(SensorTypeTest, IntegersBooleansAndChoices) {
  const std::string type =
      "[parameters.port]\nkind = 'integer'\nmin = 1\nmax = 65535\n"
      "[parameters.on]\nkind = 'boolean'\ndefault = true\n"
      "[parameters.unit]\nkind = 'text'\nchoices = ['N', 'lbf']\ndefault = 'N'\n";
  const SensorEntry entry = read(type, "port = 30004\non = false");
  EXPECT_EQ(entry.number("port"), 30004);
  EXPECT_FALSE(entry.on("on"));
  EXPECT_EQ(entry.text("unit"), "N");
  EXPECT_EQ(message(type), "d.toml:1: port: missing, expected an integer from 1 to 65535");
  EXPECT_EQ(message(type, "port = 0"), "d.toml:1: port: 0 is out of range, expected an integer from 1 to 65535");
  EXPECT_EQ(message(type, "port = 1.5"), "d.toml:1: port: 1.5 is a number, expected an integer from 1 to 65535");
  EXPECT_EQ(message(type, "port = 1\non = 1"), "d.toml:2: on: 1 is an integer, expected true or false");
  EXPECT_EQ(message(type, "port = 1\nunit = 'kg'"), "d.toml:2: unit: unknown value 'kg', expected 'N' or 'lbf'");
}

TEST_F(SensorTypeTest, InvalidDeclarationsNameTheTypesFile) {
  const auto refused = [this](const std::string& keys) { return message("[parameters.a]\n" + keys, "a = 1"); };
  const std::string place = "sensors/sonar/sonar.toml:";
  EXPECT_EQ(refused(""),
            place + "1: parameters.a.kind: missing, expected 'number', 'numbers', 'integer', 'boolean' or 'text'");
  EXPECT_EQ(
      refused("kind = 'real'"),
      place +
          "2: parameters.a.kind: unknown value 'real', expected 'number', 'numbers', 'integer', 'boolean' or 'text'");
  EXPECT_EQ(refused("kind = 'number'\nmni = 1"), place + "3: parameters.a.mni: unknown key, did you mean 'min'?");
  EXPECT_EQ(refused("kind = 'number'\nsize = 2"),
            place + "3: parameters.a.size: unknown key, expected 'default', 'kind', 'max', 'min', 'text' or 'unit'");
  EXPECT_EQ(refused("kind = 'text'\nmin = 2"),
            place + "3: parameters.a.min: unknown key, expected 'choices', 'default', 'kind', 'text' or 'unit'");
  EXPECT_EQ(refused("kind = 'numbers'\nsize = 0"),
            place + "3: parameters.a.size: 0 is out of range, expected an integer from 1 to 1000");
  EXPECT_EQ(refused("kind = 'number'\nmin = 2\nmax = 1"),
            place + "4: parameters.a.max: 1 is below min, expected a number of at least 2");
  EXPECT_EQ(refused("kind = 'number'\nmax = 1\ndefault = 2"),
            place + "4: parameters.a.default: 2 is out of range, expected a number of at most 1");
  EXPECT_EQ(refused("kind = 'text'\nunit = 2"), place + "3: parameters.a.unit: 2 is an integer, expected a text");
  EXPECT_EQ(message("[parameters.rate]\nkind = 'number'\n"),
            place + "1: parameters.rate: every table of this kind has this key, expected a key of the type's own");
  EXPECT_EQ(message("parameters = 3"), place + "1: parameters: 3 is an integer, expected a table [parameters]");
}

TEST_F(SensorTypeTest, SourcesAreThoseOfTheType) {
  EXPECT_EQ(read("").sources, (std::vector<std::string>{"simulated", "replay"}));
  const SensorEntry camera = read("sources = ['hardware', 'simulated']\n");
  EXPECT_EQ(camera.sources, (std::vector<std::string>{"hardware", "simulated"}));
  EXPECT_EQ(camera.source, "hardware") << "the first is the default";
  EXPECT_EQ(
      message("sources = ['simulated', 'guessed']\n"),
      "sensors/sonar/sonar.toml:1: sources: unknown source 'guessed', expected 'simulated', 'replay' or 'hardware'");
  EXPECT_EQ(message("sources = []\n"), "sensors/sonar/sonar.toml:1: sources: none, expected at least one");
}

TEST_F(SensorTypeTest, TypeDeclaresWhenItNeedsTheStateOfItsRobot) {
  const std::string mass = "[parameters.mass]\nkind = 'number'\ndefault = 0\n";
  EXPECT_FALSE(read(mass).wants_effector_state);
  EXPECT_TRUE(read("effector_state = true\n" + mass).wants_effector_state);
  EXPECT_FALSE(read("effector_state_with = 'mass'\n" + mass).wants_effector_state);
  EXPECT_TRUE(read("effector_state_with = 'mass'\n" + mass, "mass = 2").wants_effector_state);
  EXPECT_EQ(message("effector_state_with = 'mas'\n" + mass),
            "sensors/sonar/sonar.toml:1: effector_state_with: 'mas' is not a parameter of kind number, expected one of "
            "this file");
}

TEST_F(SensorTypeTest, PicturesHaveASize) {
  const auto key = [](const std::string& name, const std::string& kind, const std::string& value) {
    return "[parameters." + name + "]\nkind = '" + kind + "'\ndefault = " + value + "\n";
  };
  const std::string width = key("width", "number", "640");
  EXPECT_FALSE(read(width).gives_pictures);
  const SensorEntry camera = read("pictures = true\n" + width + key("height", "number", "480"), "height = 360");
  EXPECT_TRUE(camera.gives_pictures);
  EXPECT_EQ(camera.picture_width(), 640);
  EXPECT_EQ(camera.picture_height(), 360);
  for (const std::string& other : {std::string{}, key("height", "text", "'480'"),
                                   key("height", "numbers", "[4.0, 8.0]"), key("heigth", "number", "480")})
    EXPECT_EQ(message("pictures = true\n" + width + other),
              "sensors/sonar/sonar.toml:1: pictures: true without the parameter 'height' of kind number, expected it, "
              "in px");
}

TEST_F(SensorTypeTest, SidesOfPicturesAreWholeNumbers) {
  const std::string type =
      "pictures = true\n[parameters.width]\nkind = 'number'\ndefault = 640\n[parameters.height]\nkind = 'number'\n"
      "default = 480\n";
  for (const char* wrong : {"0", "-1", "640.5", "1e10"})
    EXPECT_NE(message(type, std::string("height = ") + wrong).find("d.toml:1: height: "), std::string::npos)
        << message(type, std::string("height = ") + wrong);
}

TEST_F(SensorTypeTest, ChannelsAreDeclared) {
  const std::string two = "[[channels]]\nname = 'x'\nunit = 'm'\n[[channels]]\nname = 'y'\nunit = 'm'\n";
  const SensorEntry sensor = read(two + "[[raw_channels]]\nname = 'echo'\nunit = 's'\n");
  ASSERT_EQ(sensor.channels.size(), 2u);
  EXPECT_EQ(sensor.channels[1].name, "y");
  ASSERT_EQ(sensor.raw_channels.size(), 1u);
  EXPECT_EQ(sensor.raw_channels[0].unit, "s");
  EXPECT_EQ(message("[[channels]]\nname = 'x'\n"),
            "sensors/sonar/sonar.toml:1: channels[0].unit: missing, expected a text");
  EXPECT_EQ(message(two + "[[channels]]\nname = 'x'\nunit = 's'\n"),
            "sensors/sonar/sonar.toml:8: channels[2].name: 'x' is the name of an earlier channel, expected a unique "
            "name");
}

}  // namespace
}  // namespace mrroc::config::sensor_type_test
