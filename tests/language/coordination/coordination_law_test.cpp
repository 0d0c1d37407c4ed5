// The law of a Move in which the MP takes part, equation (11), over random scripts, against a model of its own.
#include <optional>
#include <ostream>
#include <sstream>

#include "language/coordination/fake_mp.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "mrroc/coordinated.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes::coordination_law_test {
namespace {

constexpr int kCases = 3000;
constexpr std::uint64_t kNever = 1000;

enum class Sent { nothing, plan, hold, motion, change, end };

struct CoordinationScript {
  std::vector<Sent> sent;
  std::vector<OperatorRequest> requests;  ///< at each look of the Move
  std::uint64_t condition_at = kNever;    ///< evaluations after which the condition holds
  std::uint64_t throws_at = kNever;       ///< call of next_state() that throws
  std::uint64_t robot_error_at = kNever;  ///< reply of the EDP with an error
  bool stays = false;
};

enum class End { stopped, end_motion, condition, generator, error };

/// What happens outside of the Move.
struct Seen {
  End end = End::stopped;
  std::uint64_t steps = 0, started = 0, resumed = 0, computed = 0;
  /// Of each answer to the MP: whether the ECP has left, and whether there is an error in it.
  std::vector<std::pair<Coordination, bool>> answers;
  bool operator==(const Seen&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Seen& seen) {
  out << "end " << static_cast<int>(seen.end) << ", steps " << seen.steps << ", started " << seen.started
      << ", resumed " << seen.resumed << ", computed " << seen.computed << ", answers";
  for (const auto& [coordination, error] : seen.answers)
    out << " " << static_cast<int>(coordination) << (error ? "e" : "");
  return out << "\n";
}

/// The model: the paper's loop, written for this script alone.
class Model {
 public:
  explicit Model(const CoordinationScript& script) : script_(script) {}

  Seen run() {
    if (exchange()) return end(End::error);  // the initial state
    ++seen_.started;
    for (std::size_t at = 0;; ++looks_) {
      const OperatorRequest request =
          looks_ < script_.requests.size() ? script_.requests[looks_] : OperatorRequest::none;
      if (request == OperatorRequest::stop) return end(End::stopped);
      if (request == OperatorRequest::end_motion) return end(End::end_motion);
      if (at == script_.sent.size()) return end(End::stopped);  // it waits for good
      if (const std::optional<End> over = receive(script_.sent[at++])) return end(*over);
    }
  }

 private:
  std::optional<End> receive(Sent sent) {
    if (sent == Sent::nothing) return std::nullopt;
    if (sent == Sent::end) {
      ended_ = true;
      seen_.answers.emplace_back(Coordination::takes_part, false);
      return evaluate();
    }
    if (sent == Sent::plan) ended_ = false;
    if (sent == Sent::plan || sent == Sent::change) {
      const bool error = exchange();
      seen_.answers.emplace_back(Coordination::takes_part, error);
      if (sent == Sent::change) return std::nullopt;
      if (error) return End::error;
      ++seen_.resumed;
      return std::nullopt;
    }
    pending_ = true;
    if (const std::optional<End> over = evaluate()) return over;
    if (sent == Sent::motion && seen_.computed++ == script_.throws_at) return fail();
    pending_ = false;
    const bool error = exchange();
    seen_.answers.emplace_back(Coordination::takes_part, error);
    ++seen_.steps;
    return error ? std::optional(End::error) : std::nullopt;
  }

  std::optional<End> evaluate() {
    const bool condition = evaluations_++ >= script_.condition_at;
    if (condition) return End::condition;
    if (ended_ && !script_.stays) return End::generator;
    return std::nullopt;
  }

  std::optional<End> fail() {
    failed_ = true;
    return End::error;
  }

  bool exchange() { return exchanges_++ == script_.robot_error_at; }

  Seen end(End how) {
    seen_.end = how;
    if (pending_) seen_.answers.emplace_back(Coordination::left, failed_);
    return seen_;
  }

  CoordinationScript script_;
  Seen seen_;
  std::uint64_t looks_ = 0, evaluations_ = 0, exchanges_ = 0;
  bool ended_ = false, pending_ = false, failed_ = false;
};

class Following : public Coordinated {
 public:
  Following(Superior& superior, Robot& robot, const CoordinationScript& script, Seen& seen)
      : Coordinated("Following", superior), robot_(robot), script_(script), seen_(seen) {
    if (script.stays) stay();
  }
  void start() override { ++seen_.started; }
  void resume() override { ++seen_.resumed; }
  void next_state() override {
    if (seen_.computed++ == script_.throws_at) throw NonFatalError{"as planned"};
    robot_.command() = superior().command();
  }

 private:
  Robot& robot_;
  const CoordinationScript& script_;
  Seen& seen_;
};

FakeMp::Item item_of(Sent sent) {
  switch (sent) {
    case Sent::nothing: {
      FakeMp::Item none;
      none.sent = false;
      return none;
    }
    case Sent::plan:
      return item(CommandKind::query);
    case Sent::hold:
      return item(CommandKind::hold);
    case Sent::change:
      return item(CommandKind::set_tool);
    case Sent::end:
      return item(CommandKind::end);
    case Sent::motion:
      break;
  }
  FakeMp::Item made = item(CommandKind::joint);
  made.command.joints = JointVector::Constant(6, 0.1);
  return made;
}

Seen execute(const CoordinationScript& script) {
  FakeTask task;
  FakeMp mp;
  const auto arm = task.robot("arm");
  task.requests = script.requests;
  if (script.robot_error_at != kNever)
    task.robot_fake("arm").errors[script.robot_error_at] = {ErrorClass::non_fatal, ErrorCode::joint_limit, {}};
  for (const Sent sent : script.sent) mp.items.push_back(item_of(sent));
  Superior superior(mp);
  Seen seen;
  Following following(superior, *arm, script, seen);
  std::uint64_t evaluations = 0;
  following.until(When{"over", [&] { return evaluations++ >= script.condition_at; }});
  try {
    const Outcome outcome = Move({*arm}, {}, following);
    seen.end = outcome.ending == Ending::condition    ? End::condition
               : outcome.ending == Ending::end_motion ? End::end_motion
                                                      : End::generator;
  } catch (const Stopped&) {
    seen.end = End::stopped;
  } catch (const NonFatalError&) {
    seen.end = End::error;
  }
  seen.steps = task.black_box().empty() ? 0 : task.black_box().newest().step;
  for (const RobotState& state : mp.replies)
    seen.answers.emplace_back(state.coordination, state.error.error_class != ErrorClass::none);
  EXPECT_FALSE(mp.joined);
  return seen;
}

CoordinationScript random_script() {
  const auto among = [](int count) { return *rc::gen::inRange(0, count); };
  CoordinationScript script;
  const int length = among(25);
  bool over = true;  // a Move of the MP begins with a plan
  for (int i = 0; i < length; ++i) {
    const int choice = among(100);
    Sent sent = Sent::motion;
    if (over)
      sent = choice < 30 ? Sent::nothing : choice < 40 ? Sent::change : Sent::plan;
    else if (choice < 15)
      sent = Sent::nothing;
    else if (choice < 25)
      sent = Sent::plan;
    else if (choice < 40)
      sent = Sent::hold;
    else if (choice < 45)
      sent = Sent::change;
    else if (choice < 55)
      sent = Sent::end;
    if (sent == Sent::plan) over = false;
    if (sent == Sent::end) over = true;
    script.sent.push_back(sent);
  }
  for (int i = among(30); i > 0; --i) {
    const int choice = among(100);
    script.requests.push_back(choice < 90   ? OperatorRequest::none
                              : choice < 96 ? OperatorRequest::pause
                              : choice < 98 ? OperatorRequest::end_motion
                                            : OperatorRequest::stop);
  }
  if (among(3) == 0) script.condition_at = static_cast<std::uint64_t>(among(10));
  if (among(4) == 0) script.throws_at = static_cast<std::uint64_t>(among(10));
  if (among(4) == 0) script.robot_error_at = static_cast<std::uint64_t>(among(15));
  script.stays = among(2) == 0;
  return script;
}

TEST(CoordinationLaw, MoveIsEquation11) {
  check_property(kCases, [] {
    const CoordinationScript script = random_script();
    const Seen seen = execute(script), predicted = Model(script).run();
    RC_CLASSIFY(seen.end == End::condition, "condition");
    RC_CLASSIFY(seen.end == End::generator, "generator");
    RC_CLASSIFY(seen.end == End::error, "error");
    RC_CLASSIFY(seen.end == End::stopped, "stopped");
    if (seen == predicted) return;
    std::ostringstream text;
    text << "seen " << seen << "predicted " << predicted;
    RC_FAIL(text.str());
  });
}

TEST(CoordinationLaw, CommandsHaveTheMacrostepAndTheStartOfTheMp) {
  FakeTask task;
  FakeMp mp;
  const auto arm = task.robot("arm");
  mp.items = {item_of(Sent::plan), item_of(Sent::motion), item_of(Sent::hold)};
  mp.items[1].command.motion_steps = mp.items[2].command.motion_steps = 7;
  mp.items[1].command.reply_step = mp.items[2].command.reply_step = 5;
  mp.items[1].command.start_tick = 1100;
  Superior superior(mp);
  Seen seen;
  const CoordinationScript script;
  Following following(superior, *arm, script, seen);
  EXPECT_THROW(Move({*arm}, {}, following), Stopped);
  std::vector<Call> sent;
  for (const Call& call : task.log.calls)
    if (call.action == Action::send && call.kind != CommandKind::query) sent.push_back(call);
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(sent[0].tick, 1100U);
  EXPECT_EQ(sent[0].motion_steps, 7);
  EXPECT_EQ(sent[0].reply_step, 5);
  EXPECT_EQ(sent[1].motion_steps, 7);
  EXPECT_EQ(mp.replies.back().macrostep_start, 1107U);
}

TEST(CoordinationLaw, OneRobotOnly) {
  FakeTask task;
  FakeMp mp;
  const auto left = task.robot("left"), right = task.robot("right");
  Superior superior(mp);
  Seen seen;
  const CoordinationScript script;
  Following following(superior, *left, script, seen);
  try {
    Move({*left, *right}, {}, following);
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
  }
  EXPECT_FALSE(mp.joined);
}

}  // namespace
}  // namespace mrroc::fakes::coordination_law_test
