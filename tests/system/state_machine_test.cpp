// Tasks as state machines, with `mrroc run`, and their errors.
#include <gtest/gtest.h>

#include <cstdlib>

#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::state_machine_test {
namespace {

const std::string kTask = std::string{MRROC_SOURCE_DIR} + "/tasks/shuttle/";

/// The task with `from` replaced by `to` in its state machine, and other answers.
std::filesystem::path shuttle(const ScratchFolder& folder, const std::string& from = "", const std::string& to = "",
                              const std::vector<std::string>& answers = {}) {
  std::string states = text_of(kTask + "states.toml"), deployment = text_of(kTask + "shuttle.toml");
  const std::size_t at = states.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (!from.empty()) states.replace(at, from.size(), to);
  folder.write("states.toml", states);
  if (!answers.empty()) {
    deployment.erase(deployment.find("[[answers]]"));
    for (const std::string& answer : answers)
      deployment += "[[answers]]\nquestion = \"Once more?\"\nanswer = \"" + answer + "\"\n";
  }
  return folder.write("shuttle.toml", deployment);
}

/// The states of a run, in the order of their entry.
std::string states_of(const std::string& output) {
  std::string states;
  const std::string key = "mp: state ";
  for (std::size_t at = output.find(key); at != std::string::npos; at = output.find(key, at + 1))
    states += output.substr(at + key.size(), output.find('\n', at) - at - key.size()) + " ";
  return states;
}

TEST(StateMachine, EntersItsStatesInOrderEquallyInEveryRun) {
  const ScratchFolder folder;
  std::vector<std::string> hashes;
  for (const std::string name : {"first", "second"}) {
    const auto trace = folder.path() / (name + ".mcap");
    const std::string output = run_mrroc({"run", kTask + "shuttle.toml", "--record", trace.string()}, 0);
    EXPECT_EQ(states_of(output), "bring both more back bring both more home ") << output;
    EXPECT_NE(output.find("shuttle succeeded"), std::string::npos) << output;
    hashes.push_back(trace_hash(trace));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  const std::string real = run_mrroc({"run", kTask + "shuttle.toml", "--clock", "real"}, 0);
  EXPECT_EQ(states_of(real), "bring both more back bring both more home ") << real;
}

TEST(StateMachine, EntersAStateNoMoreOftenThanAllowed) {
  const ScratchFolder folder;
  const std::string output = run_mrroc({"run", shuttle(folder, "", "", {"yes"}).string()}, 0);
  EXPECT_EQ(states_of(output), "bring both more back bring both more back bring both more back bring both more home ")
      << output;
}

TEST(StateMachine, ContinuesAtTheEndOfTheFirstAndStopsTheOther) {
  const ScratchFolder folder;
  const std::string output = run_mrroc({"run", shuttle(folder, "until = \"all\"", "until = \"any\"").string()}, 0);
  EXPECT_EQ(states_of(output), "bring both more back bring both more home ") << output;
}

TEST(StateMachine, ErrorLeadsToItsOwnStateOrEndsTheTask) {
  const ScratchFolder folder;
  const std::string fast = "behaviour = \"Go\", position = 9.0, speed = 2.0";
  const std::string handled =
      run_mrroc({"run", shuttle(folder,
                                "behaviour = \"Bring\", position = 0.1 }]\nnext = \"both\"\non = { HalfWay = "
                                "\"both\" }",
                                fast + " }]\nnext = \"both\"")
                            .string()},
                0);
  EXPECT_EQ(states_of(handled), "bring home ") << handled;
  const std::string failed =
      run_mrroc({"run", shuttle(folder, "position = 0.1, speed = 0.5", "position = 0.1, speed = 2.0").string()}, 1);
  EXPECT_EQ(states_of(failed), "bring both ") << failed;
}

TEST(StateMachine, IsCheckedBeforeAnythingStarts) {
  struct Wrong {
    std::string from, to, message;
  };
  const std::vector<Wrong> wrongs = {
      {"first = \"bring\"", "first = \"brin\"", "states.toml:2: first: "},
      {"robot = \"left\", behaviour = \"Bring\"", "robot = \"middle\", behaviour = \"Bring\"",
       "states.bring.start[0].robot"},
      {"behaviour = \"Bring\"", "behaviour = \"Brings\"", "states.bring.start[0].behaviour"},
      {"behaviour = \"Bring\", position = 0.1", "behaviour = \"Bring\"", "states.bring.start[0].position"},
      {"behaviour = \"Bring\", position = 0.1", "behaviour = \"Bring\", position = \"here\"",
       "states.bring.start[0].position"},
      {"behaviour = \"Bring\", position = 0.1", "behaviour = \"Bring\", position = 0.1, sped = 1.0",
       "states.bring.start[0].sped"},
      {"HalfWay = \"both\"", "Whole = \"both\"", "no robot that this state starts sends it, expected 'HalfWay'"},
      {"no = \"home\"", "no = \"hom\"", "states.more.no"},
      {"until = \"all\"", "until = \"some\"", "states.both.until"},
      {"next = \"more\"", "next = \"bring\"", "no transition leads to this state"},
      {"next = \"end\"", "next = \"home\"", "the task can never end from this state"},
      {"[states.home]", "[states.end]\nask = \"?\"\nyes = \"home\"\nno = \"home\"\n[states.home]",
       "is the end of the task"},
      {"{ robot = \"right\", behaviour = \"Go\", position = 0.1",
       "{ robot = \"left\", behaviour = \"Go\", position = 0.1", "'left' is started twice"},
      {"at_most = 3", "at_most = 0", "states.back.at_most"},
  };
  for (const Wrong& wrong : wrongs) {
    const ScratchFolder folder;
    const std::string output = run_mrroc({"run", "--check", shuttle(folder, wrong.from, wrong.to).string()}, 2);
    EXPECT_NE(output.find(wrong.message), std::string::npos) << wrong.message << " is missing in\n" << output;
    EXPECT_NE(output.find("states.toml:"), std::string::npos) << output;
  }
}

TEST(StateMachine, IsDrawnAsAGraph) {
  const ScratchFolder folder;
  const std::string dot = run_mrroc({"graph", kTask + "shuttle.toml"}, 0);
  for (const std::string line :
       {"digraph task {", "\"\" -> \"bring\";", "\"bring\" -> \"both\" [label=\"HalfWay\"];",
        "\"bring\" -> \"home\" [label=\"non-fatal error\", style=dashed];", "\"more\" -> \"back\" [label=\"yes\"];",
        "\"back\" -> \"home\" [label=\"entered 3 times\", style=dotted];", "left: Go (position = 0.1, speed = 0.5)"})
    EXPECT_NE(dot.find(line), std::string::npos) << line << " is missing in\n" << dot;
  const auto picture = folder.path() / "shuttle.svg";
  run_mrroc({"graph", kTask + "shuttle.toml", "-o", picture.string()}, 0);
  // also when the caller ignores SIGCHLD, which a program inherits
  const std::string ignoring = "timeout 60 sh -c \"trap '' CHLD; exec " MRROC_COMMAND " graph " + kTask +
                               "shuttle.toml -o " + picture.string() + "\"";
  EXPECT_EQ(std::system(ignoring.c_str()), 0);
  const std::string svg = text_of(picture);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  const std::string missing = run_mrroc({"graph", std::string{MRROC_SOURCE_DIR} + "/tasks/press/press.toml"}, 2);
  EXPECT_NE(missing.find("mp.states: is missing"), std::string::npos) << missing;
}

}  // namespace
}  // namespace mrroc::test::state_machine_test
