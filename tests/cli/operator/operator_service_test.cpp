#include "cli/operator/operator_service.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "cli/operator/operator_rig.hpp"
#include "cli/operator/operator_state.hpp"

namespace mrroc::cli::operator_service_test {
namespace {

using links::TaskCommandKind;
using Kinds = std::vector<TaskCommandKind>;

TEST(OperatorService, CommandTakesEffectAtTheNextTickAndIsNoted) {
  OperatorRig rig;
  rig.next_tick();
  EXPECT_EQ(rig.received(), Kinds{TaskCommandKind::start});
  const auto& replies = rig.request(kA, "pause");
  EXPECT_TRUE(replies.empty()) << "it has not taken effect";
  EXPECT_TRUE(rig.received().empty());
  rig.next_tick();
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_TRUE(replies[0].ok());
  EXPECT_EQ(replies[0].tick, 1);
  EXPECT_EQ(rig.received(), Kinds{TaskCommandKind::pause});
  EXPECT_EQ(rig.service.phase(), TaskPhase::paused);
  ASSERT_EQ(rig.noted.size(), 2U);
  EXPECT_EQ(rig.noted[0].command, "start");
  EXPECT_EQ(rig.noted[0].tick, 0);
  EXPECT_EQ(rig.noted[1].command, "pause");
  EXPECT_EQ(rig.noted[1].tick, 1);
}

/// The verbs that have an effect in a phase; the others are refused, and no command is sent.
TEST(OperatorService, EveryPhaseAcceptsItsVerbs) {
  struct Case {
    std::vector<std::string> before;
    bool hold;
    std::vector<std::string> accepted;
  };
  const std::vector<std::string> all{"start", "pause", "resume", "trigger", "stop", "estop", "reset"};
  const Case cases[] = {{{}, true, {"start", "stop", "estop", "reset"}},
                        {{}, false, {"pause", "trigger", "stop", "estop", "reset"}},
                        {{"pause"}, false, {"resume", "trigger", "stop", "estop", "reset"}},
                        {{"pause", "resume"}, false, {"pause", "trigger", "stop", "estop", "reset"}},
                        {{"start"}, true, {"pause", "trigger", "stop", "estop", "reset"}},
                        {{"stop"}, false, {"estop"}},
                        {{"stop"}, true, {"estop"}}};
  for (const Case& one : cases) {
    for (const std::string& verb : all) {
      OperatorRig rig(asking_deployment(config::ClockMode::paced), one.hold);
      rig.next_tick();
      for (const std::string& before : one.before) {
        rig.request(kA, before);
        rig.next_tick();
      }
      rig.received();
      const auto& replies = rig.request(kB, verb);
      rig.next_tick();
      ASSERT_EQ(replies.size(), 1U);
      const bool accepted = std::find(one.accepted.begin(), one.accepted.end(), verb) != one.accepted.end();
      EXPECT_EQ(replies[0].ok(), accepted) << verb << " after " << one.before.size() << ": " << to_text(replies[0]);
      if (accepted) continue;
      EXPECT_EQ(replies[0].refusal, Refusal::not_allowed);
      EXPECT_FALSE(replies[0].expected.empty()) << verb;
      EXPECT_TRUE(rig.received().empty()) << verb;
    }
  }
}

TEST(OperatorService, SpeedReachesTheTaskAndTheStatus) {
  OperatorRig rig(asking_deployment(config::ClockMode::paced), true);
  rig.next_tick();
  EXPECT_NE(rig.request(kA, "status").back().data.find("\"speed\":1.0"), std::string::npos);
  rig.request(kA, "speed 30");
  rig.next_tick();
  links::TaskCommand command;
  ASSERT_TRUE(rig.task.take(command)) << "before the start, too";
  EXPECT_EQ(command.kind, TaskCommandKind::speed);
  EXPECT_EQ(command.speed, 0.3);
  EXPECT_NE(rig.published.back().find("\"value\":30.0"), std::string::npos) << rig.published.back();
  EXPECT_EQ(rig.noted.back().value, 30);
  const std::string state = rig.request(kA, "status").back().data;
  EXPECT_NE(state.find("\"speed\":0.3"), std::string::npos) << state;
  EXPECT_NE(state_text(state).find("30 %"), std::string::npos);
  rig.request(kA, "speed 100");
  rig.next_tick();
  EXPECT_EQ(state_text(rig.request(kA, "status").back().data).find("%"), std::string::npos);
}

TEST(OperatorService, RefusesInvalidSpeeds) {
  OperatorRig rig;
  rig.next_tick();
  rig.received();
  for (const char* line :
       {"speed 0", "speed 101", "speed fast", "speed", "speed -5", "speed nan", "speed 0.5", "speed 5 6"}) {
    const VerbReply reply = rig.request(kA, line).back();
    EXPECT_EQ(reply.refusal, Refusal::invalid_argument) << line;
    EXPECT_FALSE(reply.expected.empty()) << line;
  }
  rig.next_tick();
  EXPECT_TRUE(rig.received().empty());
}

TEST(OperatorService, TaskStoppedBeforeItsStartGetsNoCommand) {
  OperatorRig rig(asking_deployment(config::ClockMode::paced), true);
  rig.next_tick();
  rig.request(kA, "stop");
  rig.next_tick();
  EXPECT_TRUE(rig.events.stopped_before_start());
  EXPECT_TRUE(rig.received().empty());
}

TEST(OperatorService, StartEventOfTheDeploymentReplacesTheStartAtTickZero) {
  config::Deployment deployment = asking_deployment(config::ClockMode::lockstep);
  deployment.events = {{.tick = 2, .command = "start"}};
  OperatorRig rig(deployment);
  rig.next_tick();
  rig.next_tick();
  EXPECT_TRUE(rig.received().empty());
  EXPECT_EQ(rig.service.phase(), TaskPhase::held);
  rig.next_tick();
  EXPECT_EQ(rig.received(), Kinds{TaskCommandKind::start});
}

TEST(OperatorService, OneClientHoldsCommandAndStopIsEverybodys) {
  OperatorRig rig;
  rig.next_tick();
  EXPECT_TRUE(rig.request(kA, "command").back().ok());
  for (const char* verb : {"pause", "resume", "trigger", "reset", "answer 3", "command"}) {
    EXPECT_EQ(rig.request(kB, verb).back().refusal, Refusal::not_commander) << verb;
    EXPECT_NE(rig.replies[kB.number].back().text.find("a holds command"), std::string::npos);
  }
  EXPECT_NE(std::find(rig.shown.begin(), rig.shown.end(), "b asks for command, a holds it"), rig.shown.end());
  EXPECT_EQ(rig.request(kB, "release").back().refusal, Refusal::not_allowed);
  EXPECT_TRUE(rig.request(kB, "status").back().ok());
  rig.received();
  rig.request(kB, "estop");
  rig.request(kB, "stop");
  rig.next_tick();
  EXPECT_EQ(rig.clock.emergency_stop().presses(), 1U);
  EXPECT_EQ(rig.received(), Kinds{TaskCommandKind::stop});
}

TEST(OperatorService, EveryClientRecordsWithoutCommandAndNothingIsNoted) {
  OperatorRig rig;
  EXPECT_EQ(rig.request(kA, "record a.mcap").back().refusal, Refusal::not_allowed) << "the run has no black boxes";
  std::vector<std::string> files;
  rig.service.record_with([&files](const std::string& file) {
    files.push_back(file);
    if (file == "early.mcap") throw std::logic_error("no task has made a step");
    if (file == "old.mcap") throw std::runtime_error("the black box old.mcap: is a file that exists");
    return "50 steps of arm; black box: " + file;
  });
  rig.next_tick();
  EXPECT_TRUE(rig.request(kA, "command").back().ok());
  const std::vector<config::Event> noted = rig.noted;
  const VerbReply reply = rig.request(kB, "record new.mcap").back();
  EXPECT_TRUE(reply.ok()) << to_text(reply);
  EXPECT_EQ(reply.text, "50 steps of arm; black box: new.mcap");
  EXPECT_EQ(reply.tick, 0);
  EXPECT_NE(rig.published.back().find("record by b: 50 steps of arm"), std::string::npos) << rig.published.back();
  EXPECT_EQ(rig.request(kB, "record early.mcap").back().refusal, Refusal::not_allowed);
  const VerbReply refused = rig.request(kB, "record old.mcap").back();
  EXPECT_EQ(refused.refusal, Refusal::invalid_argument);
  EXPECT_NE(refused.text.find("exists"), std::string::npos) << refused.text;
  EXPECT_FALSE(refused.expected.empty());
  EXPECT_EQ(files, (std::vector<std::string>{"new.mcap", "early.mcap", "old.mcap"}));
  rig.next_tick();
  EXPECT_EQ(rig.noted.size(), noted.size());
}

TEST(OperatorService, CommandIsFreeAfterReleaseAndAfterADisconnection) {
  OperatorRig rig;
  rig.next_tick();
  EXPECT_TRUE(rig.request(kA, "command").back().ok());
  EXPECT_TRUE(rig.request(kA, "command").back().ok()) << "it holds it";
  EXPECT_TRUE(rig.request(kA, "release").back().ok());
  EXPECT_TRUE(rig.request(kB, "command").back().ok());
  rig.service.leave(kB);
  EXPECT_TRUE(rig.request(kA, "command").back().ok());
}

TEST(OperatorService, ClientThatHasLeftGetsNoReplyAndItsCommandTakesEffect) {
  OperatorRig rig;
  rig.next_tick();
  const auto& replies = rig.request(kA, "pause");
  rig.service.leave(kA);
  rig.next_tick();
  EXPECT_TRUE(replies.empty());
  EXPECT_EQ(rig.service.phase(), TaskPhase::paused);
}

TEST(OperatorService, EndOfTheRunRefusesWhatWaitsForItsTick) {
  OperatorRig rig;
  rig.next_tick();
  const auto& replies = rig.request(kA, "pause");
  rig.service.end(4, "a process died");
  ASSERT_EQ(replies.size(), 1U);
  EXPECT_EQ(replies[0].refusal, Refusal::ended);
  EXPECT_EQ(rig.published.back(), R"({"event":"end","exit_code":4,"reason":"a process died"})");
}

TEST(OperatorService, AnswerGoesToTheNamedOrTheFirstQuestion) {
  OperatorRig rig;
  links::OperatorRequester parts(rig.net.domain, rig.clock, "t/parts"), weight(rig.net.domain, rig.clock, "t/weight");
  parts.connect(links::kPatience);
  weight.connect(links::kPatience);
  rig.next_tick();
  EXPECT_EQ(rig.request(kA, "answer 3").back().refusal, Refusal::not_allowed);
  parts.ask(number_question("How many?", 0));
  weight.ask(number_question("How heavy?", 1));
  rig.questions.poll();
  EXPECT_EQ(rig.request(kA, "answer 10").back().refusal, Refusal::invalid_argument);
  EXPECT_EQ(rig.request(kA, "answer from=mp 1").back().refusal, Refusal::not_allowed);
  rig.request(kA, "answer from=weight 7");
  rig.request(kA, "answer 3");
  rig.next_tick();
  links::OperatorAnswer answer;
  ASSERT_TRUE(weight.take(answer));
  EXPECT_EQ(answer.value, 7);
  EXPECT_EQ(answer.question, 1U);
  ASSERT_TRUE(parts.take(answer));
  EXPECT_EQ(answer.value, 3);
  EXPECT_EQ(rig.noted.back().asker, "parts");
}

TEST(OperatorService, LiveAnswerIsRefusedUnderLockstep) {
  OperatorRig rig(asking_deployment(config::ClockMode::lockstep));
  links::OperatorRequester parts(rig.net.domain, rig.clock, "t/parts");
  parts.connect(links::kPatience);
  rig.next_tick();
  parts.ask(number_question("How many?", 0));
  rig.questions.poll();
  EXPECT_EQ(rig.request(kA, "answer 3").back().refusal, Refusal::not_allowed);
}

TEST(OperatorService, EmergencyStopWaitsForNoTickUnderTheRealClock) {
  OperatorRig rig(asking_deployment(config::ClockMode::real));
  rig.request(kA, "estop");
  EXPECT_EQ(rig.clock.emergency_stop().presses(), 1U);
  rig.service.poll();
  ASSERT_EQ(rig.replies[kA.number].size(), 1U);
  EXPECT_TRUE(rig.replies[kA.number][0].ok());
}

TEST(OperatorService, WhileProcessesStartOnlyStopsAndReportsWork) {
  const config::Deployment deployment = asking_deployment(config::ClockMode::paced);
  OperatorService service(deployment);
  int ended = 0;
  service.end_with([&ended] { ++ended; });
  const auto reply_to = [&service](const char* line) {
    VerbReply reply, refusal;
    service.request(kA, *parse_typed(line, refusal), [&reply](const VerbReply& given) { reply = given; });
    return reply;
  };
  for (const char* verb : {"start", "pause", "trigger", "reset", "answer 1"})
    EXPECT_EQ(reply_to(verb).refusal, Refusal::not_allowed) << verb;
  EXPECT_NE(reply_to("status").data.find(R"("task":"starting")"), std::string::npos);
  EXPECT_EQ(ended, 0);
  EXPECT_TRUE(reply_to("stop").ok());
  EXPECT_TRUE(reply_to("estop").ok());
  EXPECT_EQ(ended, 2);
}

}  // namespace
}  // namespace mrroc::cli::operator_service_test
