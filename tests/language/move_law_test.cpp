// The laws of Move and Wait over random scripts, checked against the reference model, and one by one on the log of the
// calls.
#include <map>
#include <set>

#include "language/exchanges.hpp"
#include "language/property.hpp"
#include "language/script_generator.hpp"

namespace mrroc::fakes::move_law_test {
namespace {

constexpr int kCases = 1000;

void expect_as_predicted(const Script& script) {
  const RunRecord done = execute(script);
  const RunRecord predicted = predict(script);
  RC_CLASSIFY(done.error.has_value(), "error");
  RC_CLASSIFY(done.stopped, "stopped");
  RC_CLASSIFY(done.result && done.result->ending == Ending::condition, "condition");
  RC_CLASSIFY(done.result && done.result->ending == Ending::generator, "generator");
  RC_CLASSIFY(done.result && done.result->ending == Ending::end_motion, "end-motion");
  if (done == predicted) return;
  std::ostringstream text;
  text << script << "done\n" << done << "predicted\n" << predicted;
  RC_FAIL(text.str());
}

TEST(MoveLaw, MoveIsEquation5) {
  check_property(2 * kCases, [] { expect_as_predicted(random_script({.is_move = true})); });
}

TEST(MoveLaw, WaitIsEquation3) {
  check_property(2 * kCases, [] { expect_as_predicted(random_script({.is_move = false})); });
}

TEST(MoveLaw, NothingIsCommandedWhenTheConditionHoldsAtTheStart) {
  check_property(kCases, [] {
    Script script = random_script({.faults = false, .pauses = false});
    script.requests.front() = OperatorRequest::none;
    script.requests.push_back(OperatorRequest::end_motion);
    if (script.is_move && detail::chance(50)) script.generator_ends = 0;
    const bool holds = !script.nodes.empty() && predict_value(script, script.nodes.size() - 1, 0);
    if (!holds && script.generator_ends != 0) {
      script.leaves = {{~std::uint64_t{0}, false}};
      script.nodes = {{}};
    }
    const RunRecord run = execute(script);
    RC_ASSERT(run.result.has_value());
    RC_ASSERT(run.result->steps == 0u);
    const auto all = exchanges(run);
    RC_ASSERT(all.size() == 1u);
    for (const Call& call : all[0].calls) {
      RC_ASSERT(call.action != Action::send || call.kind == CommandKind::query);
    }
  });
}

TEST(MoveLaw, FirstCommandMayDependOnTheInitialReading) {
  check_property(kCases, [] {
    Script script = random_script({.is_move = true, .fewest_robots = 1, .faults = false, .pauses = false});
    script.sensors.insert(script.sensors.begin(), detail::random_sensor());
    script.sensors[0].ready_from = 0;
    script.nodes.clear();
    script.leaves.clear();
    script.generator_ends = 1;
    script.requests = {};
    script.robots[0].addressed = true;
    const RunRecord run = execute(script);
    const auto all = exchanges(run);
    RC_ASSERT(all.size() == 2u);
    const Call command = all[1].calls[places(all[1], {Action::send}).front()];
    RC_ASSERT(command.kind == CommandKind::joint);
    RC_ASSERT(command.value == 0.0);  // the reading number 0 of sensor0, taken at i0
  });
}

TEST(MoveLaw, AllRobotsAreCommandedBeforeAnyIsAwaited) {
  check_property(kCases, [] {
    const Script script = random_script();
    for (const Exchange& exchange : exchanges(execute(script))) {
      const auto sends = places(exchange, {Action::send});
      const auto receives = places(exchange, {Action::receive});
      RC_ASSERT(sends.size() == script.robots.size());
      RC_ASSERT(receives.size() == script.robots.size());
      if (!sends.empty()) RC_ASSERT(sends.back() < receives.front());
    }
  });
}

TEST(MoveLaw, ReadingsAreRequestedBeforeTheCommandsAndCollectedAfterTheReplies) {
  check_property(kCases, [] {
    const Script script = random_script({.fewest_robots = 1});
    for (const Exchange& exchange : exchanges(execute(script))) {
      const auto sends = places(exchange, {Action::send});
      const auto receives = places(exchange, {Action::receive});
      for (const std::size_t request : places(exchange, {Action::request})) RC_ASSERT(request < sends.front());
      for (const std::size_t collect : places(exchange, {Action::collect, Action::latest})) {
        RC_ASSERT(collect > receives.back());
      }
    }
  });
}

TEST(MoveLaw, ReadingsAreTakenAtTheStartAndEveryPeriod) {
  check_property(kCases, [] {
    const Script script = random_script();
    for (const Exchange& exchange : exchanges(execute(script))) {
      for (std::size_t i = 0; i < script.sensors.size(); ++i) {
        const SensorScript& sensor = script.sensors[i];
        std::map<Action, int> taken;
        for (const Call& call : exchange.calls) {
          if (call.device == "sensor" + std::to_string(i)) ++taken[call.action];
        }
        const int due = exchange.is_get || exchange.is_pause || exchange.step % sensor.period == 0 ? 1 : 0;
        RC_ASSERT(taken[Action::request] == (sensor.interactive ? due : 0));
        RC_ASSERT(taken[Action::collect] == (sensor.interactive ? due : 0));
        RC_ASSERT(taken[Action::latest] == (sensor.interactive ? 0 : due));  // never waits
      }
    }
  });
}

TEST(MoveLaw, ErrorIsThrownAtTheStepThatReportsIt) {
  check_property(kCases, [] {
    Script script = random_script({.faults = false, .pauses = false});
    const FaultScript fault = detail::random_fault(script);
    script.faults = {fault};
    const RunRecord run = execute(script);
    const std::string device = (fault.of_robot ? "robot" : "sensor") + std::to_string(fault.device);
    std::uint64_t received = 0;
    std::uint64_t step = 0;
    bool reached = false;
    for (const Exchange& exchange : exchanges(run)) {
      RC_ASSERT(!reached);  // nothing is exchanged after the error
      for (const Call& call : exchange.calls) {
        const bool reception =
            call.action == Action::receive || call.action == Action::collect || call.action == Action::latest;
        if (call.device == device && reception && received++ == fault.reception) reached = true;
      }
      step = exchange.step;
    }
    RC_ASSERT(run.error.has_value() == reached);
    if (!reached) return;
    RC_ASSERT(run.error->error_class == fault.error_class);
    RC_ASSERT(run.error->code == fault.code);
    RC_ASSERT(run.error->process == "test");
    RC_ASSERT(run.error->device == device);
    RC_ASSERT(run.error->step == step);
  });
}

TEST(MoveLaw, EveryCommandDuringWaitIsAHold) {
  check_property(kCases, [] {
    for (const Exchange& exchange : exchanges(execute(random_script({.is_move = false})))) {
      for (const std::size_t send : places(exchange, {Action::send})) {
        RC_ASSERT(exchange.calls[send].kind == (exchange.is_get ? CommandKind::query : CommandKind::hold));
      }
    }
  });
}

TEST(MoveLaw, ARobotThatIsNotAddressedHolds) {
  check_property(kCases, [] {
    const Script script = random_script({.is_move = true, .fewest_robots = 1});
    for (const Exchange& exchange : exchanges(execute(script))) {
      if (exchange.is_get) continue;
      const auto sends = places(exchange, {Action::send});
      for (std::size_t i = 0; i < sends.size(); ++i) {
        const bool commanded = script.robots[i].addressed && !exchange.is_pause;
        const Call& command = exchange.calls[sends[i]];
        RC_ASSERT(command.kind == (commanded ? CommandKind::joint : CommandKind::hold));
        RC_ASSERT(command.motion_steps == script.robots[i].motion_steps);
        RC_ASSERT(command.reply_step == script.robots[i].reply_step);
      }
    }
  });
}

TEST(MoveLaw, EveryPartOfAConditionIsEvaluatedOnceAStep) {
  check_property(kCases, [] {
    const Script script = random_script();
    std::map<std::string, int> leaves;  // how often each is in the tree
    for (const NodeScript& node : script.nodes) {
      if (node.kind == NodeScript::Kind::leaf) ++leaves["leaf" + std::to_string(node.a)];
    }
    std::map<std::string, int> seen;
    const auto run = execute(script);
    for (const Call& call : run.calls) {
      if (call.action == Action::evaluate) ++seen[call.device];
      if (call.action != Action::observe) continue;  // one a step, after the evaluation
      const bool evaluated = call.device.empty() || (run.result && run.result->ending != Ending::end_motion);
      RC_ASSERT(seen == (evaluated ? leaves : std::map<std::string, int>{}));
      seen.clear();
    }
    RC_ASSERT(count(run, Action::start_condition) <= [&] {
      std::uint64_t n = 0;
      for (const auto& leaf : leaves) n += static_cast<std::uint64_t>(leaf.second);
      return n;
    }());
  });
}

TEST(MoveLaw, StepsAndTicksAreThoseOfTheExchanges) {
  check_property(kCases, [] {
    Script script = random_script({.fewest_robots = 1, .faults = false, .pauses = false});
    for (RobotScript& robot : script.robots) robot = script.robots[0];
    script.sensors.clear();
    const RobotScript& robot = script.robots[0];
    const RunRecord run = execute(script);
    RC_ASSERT(run.result.has_value());
    RC_ASSERT(run.result->steps + 1 == exchanges(run).size());
    RC_ASSERT(run.result->start_tick == 1000u);
    // macrosteps follow each other without a gap while v <= N and the robots move, or one is alone
    if (script.robots.size() == 1 && run.result->steps > 0) {
      const auto period = static_cast<Tick>(std::max(robot.motion_steps, robot.reply_step));
      const Tick last = static_cast<Tick>(robot.reply_step);
      RC_ASSERT(run.result->end_tick == 1000 + period * (run.result->steps - 1) + last);
    }
    RC_ASSERT(run.result->duration == static_cast<double>(run.result->end_tick - 1000) * 0.002);
  });
}

TEST(MoveLaw, PauseHoldsTheRobotsAndResumesTheGeneratorButNoCondition) {
  check_property(kCases, [] {
    Script script = random_script({.faults = false, .pauses = false});
    const auto begin = static_cast<std::size_t>(pick(0, static_cast<int>(script.requests.size()) - 1));
    const auto length = static_cast<std::size_t>(pick(1, 6));
    script.requests.insert(script.requests.begin() + static_cast<std::ptrdiff_t>(begin), length,
                           OperatorRequest::pause);
    Script unpaused = script;
    std::erase(unpaused.requests, OperatorRequest::pause);
    const RunRecord with = execute(script);
    const RunRecord without = execute(unpaused);
    RC_ASSERT(with.result.has_value());
    RC_ASSERT(without.result.has_value());
    std::size_t holds = 0;
    for (const Exchange& exchange : exchanges(with)) {
      if (!exchange.is_pause) continue;
      ++holds;
      for (const std::size_t send : places(exchange, {Action::send})) {
        RC_ASSERT(exchange.calls[send].kind == CommandKind::hold);
      }
    }
    const bool paused =
        without.result->steps > begin || (without.result->steps == begin);  // once a step, including the last one
    RC_ASSERT(holds == (paused ? length : 0u));
    // a following end-motion ends the pause: nothing is resumed
    const bool resumed = paused && script.requests[begin + length] == OperatorRequest::none;
    RC_ASSERT(count(with, Action::resume_generator) == (resumed && script.is_move ? 1u : 0u));
    RC_ASSERT(count(with, Action::start_condition) == count(without, Action::start_condition));
    RC_ASSERT(count(with, Action::evaluate) == count(without, Action::evaluate));
    RC_ASSERT(with.result->steps == without.result->steps);
    RC_ASSERT(with.result->ending == without.result->ending);
  });
}

TEST(MoveLaw, StopAndEndMotionLeaveAtOnce) {
  check_property(kCases, [] {
    Script script = random_script({.faults = false, .pauses = false});
    const auto place = static_cast<std::size_t>(pick(0, static_cast<int>(script.requests.size()) - 1));
    const bool stop = detail::chance(50);
    const std::uint64_t uninterrupted = execute(script).result->steps;
    script.requests[place] = stop ? OperatorRequest::stop : OperatorRequest::end_motion;
    const RunRecord run = execute(script);
    if (uninterrupted < place) return RC_ASSERT(run.result.has_value());
    RC_ASSERT(run.stopped == stop);
    RC_ASSERT(run.result.has_value() == !stop);
    RC_ASSERT(exchanges(run).size() == place + 1);
    if (!stop) RC_ASSERT(run.result->ending == Ending::end_motion);
    RC_ASSERT(count(run, Action::observe) == place + 1);
  });
}

TEST(MoveLaw, SeveralRobotsStartOnOneTick) {
  check_property(kCases, [] {
    const Script script = random_script({.fewest_robots = 1, .faults = false, .pauses = false});
    for (const Exchange& exchange : exchanges(execute(script))) {
      std::set<Tick> starts;
      for (const std::size_t send : places(exchange, {Action::send})) starts.insert(exchange.calls[send].tick);
      RC_ASSERT(starts.size() == 1u);
      const bool given = *starts.begin() != 0;
      RC_ASSERT(given == (script.robots.size() > 1 && !exchange.is_get));
    }
  });
}

}  // namespace
}  // namespace mrroc::fakes::move_law_test
