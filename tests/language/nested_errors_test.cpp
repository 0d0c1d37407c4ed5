// One error propagates outwards from the Move that meets it, and is the same wherever it is caught. Robots get no
// commands meanwhile.
#include <gtest/gtest.h>

#include <algorithm>

#include "language/drive.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::nested_errors_test {
namespace {

using fakes::Action;
using fakes::Drive;
using fakes::FakeTask;

std::size_t sent(const FakeTask& task, bool holds = false) {
  return static_cast<std::size_t>(
      std::count_if(task.log.calls.begin(), task.log.calls.end(), [holds](const fakes::Call& call) {
        return call.action == Action::send && (call.kind == CommandKind::hold) == holds;
      }));
}

/// A task with the structure of a program: a Move in a behaviour in a run, any of which may catch. It has two robots,
/// one of which reports an error at the fourth step.
struct Program {
  explicit Program(ErrorReport report) { task.robot_fake("right").errors[4] = report; }

  void move() { Move({*left, *right}, {}, Drive{{left.get(), right.get()}}.until(ElapsedSteps{10})); }
  void behaviour(bool catches) {
    Wait({*left}, {}, ElapsedSteps{0});
    if (!catches) return move();
    try {
      move();
    } catch (const Error& error) {
      caught(error);
    }
  }
  void run(bool behaviour_catches, bool run_catches) {
    if (!run_catches) return behaviour(behaviour_catches);
    try {
      behaviour(behaviour_catches);
    } catch (const Error& error) {
      caught(error);
    }
  }

  void caught(const Error& error) {
    reported = error.what();
    box = error.black_box();
    sent_before = sent(task);
  }

  FakeTask task;
  std::unique_ptr<Robot> left = task.robot("left"), right = task.robot("right");
  std::string reported;
  std::shared_ptr<const BlackBox> box;
  std::size_t sent_before = 0;
};

constexpr ErrorClass kClasses[] = {ErrorClass::non_fatal, ErrorClass::hardware, ErrorClass::system};

TEST(NestedErrors, AreTheSameWhereverTheyAreCaught) {
  for (const ErrorClass error_class : kClasses) {
    const ErrorReport report{error_class, ErrorCode::drive_fault, {"axis 2"}};
    Program inner(report), middle(report), outer(report);
    inner.behaviour(true);
    middle.run(false, true);
    try {
      outer.run(false, false);
      FAIL();
    } catch (const Error& error) {
      outer.caught(error);
    }
    EXPECT_EQ(inner.reported, std::string(describe(error_class)) +
                                  ": a drive reports a fault: axis 2 [process test, device right, step 4, tick 1040]");
    for (const Program* program : {&middle, &outer}) {
      EXPECT_EQ(program->reported, inner.reported);
      EXPECT_EQ(program->box->size(), inner.box->size());
      EXPECT_EQ(program->box->newest().tick, inner.box->newest().tick);
      EXPECT_EQ(program->box->newest().states.at(1).error.code, ErrorCode::drive_fault);
    }
  }
}

TEST(NestedErrors, RobotsOfTheMoveAreCommandedNothingButToHoldAfterIt) {
  for (const ErrorClass error_class : kClasses) {
    Program program({error_class, ErrorCode::drive_fault, {}});
    program.behaviour(true);
    EXPECT_EQ(program.sent_before, 1U + 2 * 5) << "a GET of one robot; of both, and four steps";
    EXPECT_EQ(sent(program.task), program.sent_before);
    EXPECT_EQ(sent(program.task, true), error_class == ErrorClass::system ? 0U : 2U);
    if (error_class == ErrorClass::system) continue;
    for (const Robot* robot : {program.left.get(), program.right.get()})
      EXPECT_TRUE(robot->state().desired_velocity.isZero(0)) << robot->name();
  }
}

TEST(NestedErrors, TheTaskGoesOnAfterOneThatItHasCaught) {
  Program program({ErrorClass::non_fatal, ErrorCode::singular, {}});
  program.behaviour(true);
  EXPECT_EQ(Wait({*program.left, *program.right}, {}, ElapsedSteps{3}).steps, 3U);
}

}  // namespace
}  // namespace mrroc::nested_errors_test
