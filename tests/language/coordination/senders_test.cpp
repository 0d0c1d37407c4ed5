// What a Move of the MP does for the ECPs that take part in it.
#include <gtest/gtest.h>

#include "language/drive.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::senders_test {
namespace {

using fakes::Action;
using fakes::Drive;
using fakes::FakeTask;

std::vector<CommandKind> kinds(const FakeTask& task, const std::string& robot) {
  std::vector<CommandKind> sent;
  for (const fakes::Call& call : task.log.calls)
    if (call.action == Action::send && call.device == robot) sent.push_back(call.kind);
  return sent;
}

class Resumed : public Drive {
 public:
  using Drive::Drive;
  void resume() override { ++resumed; }
  int resumed = 0;
};

using Kinds = std::vector<CommandKind>;
constexpr CommandKind kQuery = CommandKind::query, kHold = CommandKind::hold, kJoint = CommandKind::joint,
                      kEnd = CommandKind::end;

TEST(Senders, MoveSendsItsEndToThoseThatTakePart) {
  FakeTask task;
  const auto left = task.robot("left"), right = task.robot("right");
  task.robot_fake("left").state.coordination = Coordination::takes_part;
  Drive drive({left.get(), right.get()}, 0);
  Move({*left, *right}, {}, drive.until(ElapsedSteps{2}));
  EXPECT_EQ(kinds(task, "left"), (Kinds{kQuery, kJoint, kJoint, kEnd}));
  EXPECT_EQ(kinds(task, "right"), (Kinds{kQuery, kJoint, kJoint}));
}

TEST(Senders, StateOfTheLastStepIsKept) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").state.coordination = Coordination::takes_part;
  task.robot_fake("arm").errors[3] = {ErrorClass::non_fatal, ErrorCode::busy, {}};  // the ECP runs its next program
  Drive drive({arm.get()}, 0);
  Move({*arm}, {}, drive.until(ElapsedSteps{2}));
  EXPECT_EQ(arm->state().error.code, ErrorCode::none);
}

TEST(Senders, WaitDoesNot) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").state.coordination = Coordination::takes_part;
  Wait({*arm}, {}, ElapsedSteps{1});
  EXPECT_EQ(kinds(task, "arm"), (Kinds{kQuery, kHold}));
}

TEST(Senders, ErrorEndsItAsWell) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").state.coordination = Coordination::takes_part;
  task.robot_fake("arm").errors[2] = {ErrorClass::non_fatal, ErrorCode::joint_limit, {}};
  EXPECT_THROW(Move({*arm}, {}, Drive({arm.get()}, 0)), NonFatalError);
  EXPECT_EQ(kinds(task, "arm"), (Kinds{kQuery, kJoint, kJoint, kEnd}));
}

TEST(Senders, SystemErrorSendsNothingMore) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").state.coordination = Coordination::takes_part;
  task.robot_fake("arm").throws[2] = [] { throw SystemError(ErrorCode::process_died, "arm"); };
  EXPECT_THROW(Move({*arm}, {}, Drive({arm.get()}, 0)), SystemError);
  EXPECT_EQ(kinds(task, "arm"), (Kinds{kQuery, kJoint, kJoint}));
}

TEST(Senders, StateIsObtainedBeforeTheGeneratorPlansAgain) {
  for (const bool takes_part : {false, true}) {
    FakeTask task;
    const auto arm = task.robot("arm");
    if (takes_part) task.robot_fake("arm").state.coordination = Coordination::takes_part;
    task.requests = {OperatorRequest::none, OperatorRequest::pause, OperatorRequest::pause};
    Resumed drive({arm.get()}, 0);
    Move({*arm}, {}, drive.until(ElapsedSteps{2}));
    EXPECT_EQ(drive.resumed, 1);
    EXPECT_EQ(kinds(task, "arm"), takes_part ? (Kinds{kQuery, kJoint, kHold, kHold, kQuery, kJoint, kEnd})
                                             : (Kinds{kQuery, kJoint, kHold, kHold, kJoint}));
  }
}

TEST(Senders, EcpThatHasLeftMakesTheMovePlanAgainFromRest) {
  FakeTask task;
  const auto left = task.robot("left"), right = task.robot("right");
  auto& fake = task.robot_fake("left");
  Resumed drive({left.get(), right.get()}, 0.1);
  int step = 0;
  drive.act = [&] { fake.state.coordination = ++step == 2 ? Coordination::left : Coordination::none; };
  Move({*left, *right}, {}, drive.until(ElapsedSteps{3}));
  EXPECT_EQ(drive.resumed, 1);
  EXPECT_EQ(kinds(task, "right"), (Kinds{kQuery, kJoint, kJoint, kHold, kJoint}));
}

}  // namespace
}  // namespace mrroc::senders_test
