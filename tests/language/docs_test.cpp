// The code of docs/explanation/language.md, compiled and run: every cpp block of the page is here between "// [name]"
// and "// [end]".
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>

#include "language/fakes.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/together.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/move.hpp"
#include "mrroc/tracker.hpp"

namespace mrroc::docs_test {
namespace {

// [own robot and sensor]
class Gantry : public Robot {
 public:
  Gantry(Task& task, const std::string& name) : Robot(task, name, {std::make_shared<fakes::FakeModel>(4)}) {}
};

class Range : public Sensor {
 public:
  Range(Task& task, const std::string& name) : Sensor(task, name, "range") {}
  double distance() const { return value(0); }  // m
};
// [end]

// [own condition]
class Closer : public Condition {
 public:
  Closer(const Range& range, double distance) : Condition("closer"), range_(&range), distance_(distance) {}

 protected:
  bool holds() override { return range_->distance() < distance_; }

 private:
  const Range* range_;
  double distance_;
};
// [end]

// [generator with a tracker]
class Seek : public Generator {
 public:
  explicit Seek(Robot& robot) : Generator("Seek"), tracker_(robot) {}
  void next_state() override { tracker_.to(where()); }
  JointVector where() const { return wanted; }
  JointVector wanted;

 private:
  Tracker tracker_;
};
// [end]

// [own generator]
class Follow : public Generator {
 public:
  Follow(Robot& leader, Robot& follower) : Generator("Follow"), leader_(leader), follower_(follower) {}

  void start() override { offset_ = follower_.state().desired_joints - leader_.state().desired_joints; }
  void next_state() override {
    follower_.command().kind = CommandKind::joint;
    follower_.command().joints = leader_.state().desired_joints + offset_;
  }

 private:
  Robot& leader_;
  Robot& follower_;
  JointVector offset_;
};
// [end]

struct Cell {
  Cell() {
    for (const char* name : {"left", "right"}) task.add_robot(name, 4);
    task.add_sensor("gate", false);
  }
  fakes::FakeTask task;
};

TEST(Docs, Task) {
  Cell cell;
  fakes::FakeTask& task = cell.task;
  // [task]
  Gantry left{task, "left"};
  Range gate{task, "gate"};

  Wait({left}, {gate}, Closer{gate, 0.10});                               // a part has come
  Move({left}, {}, JointLine{left, JointVector::Constant(4, 0.2), 0.8});  // to a place
  const Outcome end = Move({left}, {gate},
                           ToolVelocity{left, {0, 0, -0.02}}  // down ...
                               .until(Closer{gate, 0.01} || Travelled{left, 0.15}));
  if (end.by<Travelled>()) Move({left}, {}, Hold{left, 0.5});  // ... on nothing
  // [end]
  EXPECT_TRUE(end.by<Travelled>());

  task.triggers = 0;
  // [conditions]
  const Outcome seen = Wait({left}, {gate},
                            named("seen", Closer{gate, 0.3} && !OperatorTrigger{task}) || ElapsedSteps{50} ||
                                When{"too far away", [&] { return gate.distance() > 1.5; }});
  if (seen.by("seen") || seen.by<ElapsedSteps>()) throw NonFatalError("not expected here: " + seen.reason());
  // [end]
  EXPECT_EQ(seen.reason(), "too far away");
}

TEST(Docs, TwoRobots) {
  Cell cell;
  fakes::FakeTask& task = cell.task;
  Gantry left{task, "left"};
  Gantry right{task, "right"};
  Range gate{task, "gate"};
  // [two robots]
  left.set_macrostep(20, 18);  // N = 20 ticks, the reply at tick v = 18
  right.set_macrostep(20, 18);
  gate.set_period(5);  // a reading every fifth step
  Move({left, right}, {gate}, Follow{left, right}.until(ElapsedSteps{100}));
  // [end]
  EXPECT_EQ(gate.reading().sequence, 21u);
}

TEST(Docs, GeneratorWithATracker) {
  Cell cell;
  Gantry left{cell.task, "left"};
  Seek seek{left};
  seek.wanted = JointVector::Constant(4, 0.1);
  Move({left}, {}, seek.until(ElapsedSteps{100}));
  EXPECT_EQ(left.state().desired_joints, seek.wanted);
}

TEST(Docs, SeveralGenerators) {
  Cell cell;
  fakes::FakeTask& task = cell.task;
  Gantry left{task, "left"};
  Gantry right{task, "right"};
  // [several generators]
  Move({left, right}, {},
       Together{JointLine{left, JointVector::Constant(4, 0.3)}, JointLine{right, JointVector::Constant(4, 0.1), 0.9}});
  // [end]
  EXPECT_NEAR(left.state().desired_joints[0], 0.3, 1e-12);
  EXPECT_NEAR(right.state().desired_joints[0], 0.1, 1e-12);
}

TEST(Docs, Errors) {
  Cell cell;
  fakes::FakeTask& task = cell.task;
  Gantry left{task, "left"};
  task.robot_fake("left").errors[1] = {ErrorClass::hardware, ErrorCode::drive_fault, {}};
  // [errors]
  try {
    Move({left}, {}, JointLine{left, JointVector::Constant(4, 0.2)});
  } catch (const NonFatalError& error) {
    if (error.code() != ErrorCode::out_of_workspace) throw;
    Move({left}, {}, JointLine{left, JointVector::Zero(4)});
  } catch (const HardwareError& error) {
    left.recover();  // error.what(): "hardware error: a drive reports a fault [process test, device left, ...]"
  }
  // [end]
  EXPECT_EQ(left.command().kind, CommandKind::recover);
  EXPECT_EQ(left.state().error.error_class, ErrorClass::none);
}

/// Removes the common indentation of all lines.
std::string unindented(const std::vector<std::string>& lines) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : lines) indent = std::min(indent, line.find_first_not_of(' '));
  std::string text;
  for (const std::string& line : lines) text += (line.empty() ? line : line.substr(indent)) + "\n";
  return text;
}

/// The texts between a line that starts with `begins` and a line that is `end`, both without their indentation.
template <class Begins>
std::set<std::string> blocks(const std::string& path, const Begins& begins, const std::string& end) {
  std::ifstream file(std::string(MRROC_SOURCE_DIR) + "/" + path);
  std::set<std::string> found;
  std::optional<std::vector<std::string>> block;
  for (std::string line; std::getline(file, line);) {
    const std::string text = line.substr(std::min(line.size(), line.find_first_not_of(' ')));
    if (block && text == end) {
      found.insert(unindented(*block));
      block.reset();
    } else if (block) {
      block->push_back(line);
    } else if (begins(text)) {
      block.emplace();
    }
  }
  return found;
}

TEST(Docs, EveryBlockOfThePageIsCompiledHere) {
  const auto page = blocks(
      "docs/explanation/language.md", [](const std::string& line) { return line == "```cpp"; }, "```");
  const auto code = blocks(
      "tests/language/docs_test.cpp",
      [](const std::string& line) { return line.starts_with("// [") && line != "// [end]"; }, "// [end]");
  EXPECT_EQ(page.size(), 9u);
  EXPECT_EQ(page, code);
}

}  // namespace
}  // namespace mrroc::docs_test
