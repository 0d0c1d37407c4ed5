#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "config/message_of.hpp"
#include "config/resources.hpp"
#include "edp/check/model_check.hpp"
#include "edp/check/robot_check.hpp"
#include "edp/every_robot.hpp"
#include "mrroc/testing/scratch_folder.hpp"

// Each number of every robot's parameter file is made invalid: the checks of an EDP's start refuse it by name.
namespace mrroc::edp::robot_files_test {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  Lines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// One robot's file, and the errors when lines of it are replaced.
class RobotFile {
 public:
  explicit RobotFile(const KnownRobot& robot) : robot_(robot), lines_(lines_of(robot.file("toml"))) {}

  const Lines& lines() const { return lines_; }

  /// The message without its folder; empty: the file is accepted.
  std::string mistake(const Lines& lines) const {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    const task_test::ScratchFolder scratch;
    const auto file = scratch.write("robot.toml", text);
    return config::message_of(scratch.path(), [&] { check_models(robot_.load(file), config::Table::load(file)); });
  }
  std::string with(std::size_t line, const std::string& text) const {
    Lines changed = lines_;
    changed[line] = text;
    return mistake(changed);
  }

 private:
  const KnownRobot& robot_;
  Lines lines_;
};

/// `key = number` and its location.
struct Entry {
  std::size_t line;
  std::string key;
  std::string value;
};

/// Entries whose values match `pattern`, except those that only describe.py reads.
std::vector<Entry> entries(const Lines& lines, const std::string& pattern) {
  const std::regex entry("^(\\w+) = (" + pattern + ").*");
  std::vector<Entry> found;
  for (std::size_t i = 0; i < lines.size() && lines[i] != "[description]"; ++i) {
    std::smatch match;
    if (std::regex_match(lines[i], match, entry)) found.push_back({i, match[1], match[2]});
  }
  return found;
}

const std::string kNumber = "-?[0-9][0-9.e+-]*|-?inf";
const std::string kNumbers = "\\[-?[0-9][^\\]]*\\]";

/// "robot.toml:<line>: ...<key>: ", or the same with the key's index.
testing::AssertionResult names(const std::string& message, const Entry& entry) {
  const std::regex place("robot\\.toml:" + std::to_string(entry.line + 1) + ": ([\\w.\\[\\]]+\\.)?" + entry.key +
                         "(\\[\\d+\\])?: [^]*, expected [^]*");
  if (std::regex_match(message, place)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << message << "\" does not name " << entry.key << " in line "
                                     << entry.line + 1;
}

class RobotFiles : public testing::TestWithParam<KnownRobot> {
 protected:
  const RobotFile file_{GetParam()};
};

TEST_P(RobotFiles, UnchangedFilesAndTheirDescriptionsAreValid) {
  EXPECT_EQ(file_.mistake(file_.lines()), "");
  EXPECT_NO_THROW(check_robot(GetParam().load(GetParam().file("toml")), GetParam().type,
                              config::robot_files(GetParam().type, GetParam().file("toml"))));
}

TEST_P(RobotFiles, NoNumberMayBeMissing) {
  const std::vector<std::string> optional{"current_max_time", "encoder_increments", "regulator_output_max",
                                          "stuck_current",    "stuck_max",          "raised",
                                          "standard"};  // the last two are a posture and a tool
  int numbers = 0;
  for (const Entry& entry : entries(file_.lines(), kNumber + "|" + kNumbers)) {
    if (std::find(optional.begin(), optional.end(), entry.key) != optional.end()) continue;
    ++numbers;
    const std::string message = file_.with(entry.line, "");
    // one of the two synchronisation speeds alone contradicts the other
    const std::string key = entry.key == "synchro_coarse" ? "synchro_fine" : entry.key;
    EXPECT_NE(message.find(key + ": "), std::string::npos) << entry.key << " left out: " << message;
    EXPECT_NE(message.find(", expected "), std::string::npos) << message;
  }
  EXPECT_GT(numbers, 15);
}

TEST_P(RobotFiles, NoNumberMayBeNan) {
  for (const Entry& entry : entries(file_.lines(), kNumber)) {
    for (const char* wrong : {"nan", "\"1\"", "[1.0]"}) {
      EXPECT_TRUE(names(file_.with(entry.line, entry.key + " = " + wrong), entry)) << wrong;
    }
  }
}

TEST_P(RobotFiles, OnlyLimitsMayBeInfinite) {
  for (const Entry& entry : entries(file_.lines(), kNumber)) {
    if (entry.key.starts_with("position_m") || entry.key.starts_with("motor_m")) continue;
    EXPECT_TRUE(names(file_.with(entry.line, entry.key + " = inf"), entry));
  }
}

TEST_P(RobotFiles, ArraysHaveTheirSizeAndNumbers) {
  int arrays = 0;
  for (const Entry& entry : entries(file_.lines(), kNumbers)) {
    ++arrays;
    const std::string inside = entry.value.substr(1, entry.value.size() - 2);
    const std::size_t comma = inside.find(',');
    const std::string rest = comma == std::string::npos ? "" : inside.substr(comma);
    EXPECT_TRUE(names(file_.with(entry.line, entry.key + " = [" + inside + ", 0.0]"), entry));
    EXPECT_TRUE(names(file_.with(entry.line, entry.key + " = [" + (rest.empty() ? "" : rest.substr(2)) + "]"), entry));
    EXPECT_TRUE(names(file_.with(entry.line, entry.key + " = [nan" + rest + "]"), entry));
  }
  EXPECT_GE(arrays, 1);
}

TEST_P(RobotFiles, GearIsNotZero) {
  int gears = 0;
  for (const Entry& entry : entries(file_.lines(), kNumber + "|" + kNumbers)) {
    if (entry.key.find("gear") == std::string::npos) continue;
    ++gears;
    const std::size_t comma = entry.value.find(',');
    const std::string zero = entry.value.starts_with("[") ? "[0.0" + entry.value.substr(comma) : "0.0";
    EXPECT_TRUE(names(file_.with(entry.line, entry.key + " = " + zero), entry));
  }
  // the gripper's transmission is a parabola
  EXPECT_EQ(gears > 0, GetParam().type != "two_finger_gripper");
}

TEST_P(RobotFiles, LimitsDoNotCross) {
  const auto found = entries(file_.lines(), kNumber);
  int pairs = 0;
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    const Entry &low = found[i], &high = found[i + 1];
    if (!low.key.ends_with("_min") || high.key != low.key.substr(0, low.key.size() - 3) + "max") continue;
    ++pairs;
    Lines crossed = file_.lines();
    crossed[low.line] = low.key + " = " + (high.value == "inf" ? "1.0" : high.value);
    crossed[high.line] = high.key + " = " + (low.value == "-inf" ? "-1.0" : low.value);
    EXPECT_TRUE(names(file_.mistake(crossed), high));
    crossed[high.line] = high.key + " = " + (high.value == "inf" ? "1.0" : high.value);
    EXPECT_TRUE(names(file_.mistake(crossed), high)) << "no range between them";
  }
  EXPECT_EQ(pairs, 2 * GetParam().load(GetParam().file("toml")).front()->joint_count());
}

TEST_P(RobotFiles, RefusesPositionsOutsideTheirLimits) {
  const auto models = GetParam().load(GetParam().file("toml"));
  const RobotParameters& parameters = models.front()->parameters();
  const auto found = entries(file_.lines(), kNumber + "|" + kNumbers);
  const auto axis_key = [&found](const std::string& key, std::size_t axis) {
    auto entry = found.begin();
    for (std::size_t i = 0;; ++entry) {
      if (entry->key == key && i++ == axis) return *entry;
    }
  };
  const auto home = axis_key("home", 0);
  JointVector home_motors;
  ASSERT_EQ(models.front()->joints_to_motors(parameters.home, home_motors), ErrorCode::none);
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    if (std::isfinite(axis.motor_max)) {
      const Entry synchro = axis_key("motor_synchro", i);
      EXPECT_TRUE(names(file_.with(synchro.line, "motor_synchro = " + std::to_string(axis.motor_max + 1)), synchro));
      // a motor range with its synchro position, but without home
      const double at_home = home_motors[static_cast<Eigen::Index>(i)];
      const double middle = (at_home + axis.motor_synchro) / 2;
      if (middle != at_home) {
        Lines moved = file_.lines();
        const Entry inner = axis_key(middle < at_home ? "motor_max" : "motor_min", i);
        moved[inner.line] = inner.key + " = " + std::to_string(middle);
        EXPECT_TRUE(names(file_.mistake(moved), home)) << axis.name;
      }
    }
    if (std::isfinite(axis.position_max)) {
      std::ostringstream values;
      for (std::size_t j = 0; j < parameters.axes.size(); ++j) {
        values << (j == 0 ? "" : ", ")
               << std::to_string(j == i ? axis.position_max + 0.01 : parameters.home[static_cast<Eigen::Index>(j)]);
      }
      EXPECT_TRUE(names(file_.with(home.line, "home = [" + values.str() + "]"), home)) << axis.name;
      // a joint range that the motors do not reach
      const Entry limit = axis_key("position_max", i);
      EXPECT_NE(file_.with(limit.line, "position_max = " + std::to_string(axis.position_max + 1000)), "") << axis.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RobotFiles, testing::ValuesIn(every_robot()),
                         [](const auto& robot) { return robot.param.stem; });

TEST(EveryRobot, IsTestedHere) {
  std::set<std::string> types;
  for (const KnownRobot& robot : every_robot()) types.insert(robot.type);
  const std::vector<std::string> installed = config::robot_types();
  EXPECT_EQ(types, std::set(installed.begin(), installed.end()));
}

}  // namespace
}  // namespace mrroc::edp::robot_files_test
