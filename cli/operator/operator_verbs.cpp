#include "cli/operator/operator_verbs.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <vector>

#include "core/nearest_word.hpp"

namespace mrroc::cli {

namespace {

constexpr VerbArgument kAnswerArguments[]{
    VerbArgument{"value", "The answer as it would be typed: a number, yes or no, a choice or its number from 1", true},
    VerbArgument{"from", "The sensor or process that asks; default: the question that is shown", false}};

constexpr VerbArgument kSpeedArguments[]{VerbArgument{"value", "Percent of the programmed speed, 1 to 100", true}};
constexpr VerbArgument kEchoArguments[]{VerbArgument{
    "of", "changes (default), robots, readings or world: their states at most 50 times a second, or all", false}};
constexpr VerbArgument kRobot{"robot", "Name of the robot in the deployment", true};
constexpr VerbArgument kAxis{"axis", "Name or number from 1 of an axis or motor; x, y, z, rx, ry, rz of the tool",
                             true};
constexpr VerbArgument kFrame{"in", "axes (default), motors, or the axes in which the tool moves: base, tool", false};
constexpr VerbArgument kJogArguments[]{
    kRobot, kAxis, VerbArgument{"velocity", "rad/s or m/s, with sign; of a motor rad/s of its shaft", true}, kFrame};
constexpr VerbArgument kStepArguments[]{kRobot, kAxis, VerbArgument{"distance", "rad or m, with sign", true}, kFrame};
constexpr VerbArgument kGoArguments[]{
    kRobot, VerbArgument{"posture", "A posture of the robot's parameter file: home, or one of [postures]", true}};
constexpr VerbArgument kToolArguments[]{
    kRobot, VerbArgument{"tool", "A tool of the robot's parameter file: flange, or one of [tools]", true}};
constexpr VerbArgument kRobotArguments[]{kRobot};
constexpr VerbArgument kOutputArguments[]{
    kRobot, VerbArgument{"output", "0 to 15: a digital output; a0 to a7: an analogue one", true},
    VerbArgument{"value", "0 or 1 of a digital output; a number of an analogue one", true}};
constexpr VerbArgument kFollowArguments[]{
    kRobot,
    VerbArgument{"file", "The trajectory, TOML; a relative path begins in the folder of the caller", true, true}};
constexpr VerbArgument kRecordArguments[]{
    VerbArgument{"file", "A file that does not exist; a relative path begins in the folder of the caller", true, true}};

constexpr OperatorVerb kVerbs[]{
    OperatorVerb{
        "status", "Show the state of the task, the processes, the open questions and the commander", "", {}, false},
    OperatorVerb{"echo", "Show messages, questions and changes of state from now on, as they happen", "",
                 kEchoArguments, false},
    OperatorVerb{"command", "Take command and keep it until 'release' or the end of the connection", "", {}, true},
    OperatorVerb{"release", "Give command back", "", {}, false},
    OperatorVerb{"start", "Start the task of a run that waits for it (--hold)", "the task has started", {}, true},
    OperatorVerb{
        "pause", "Bring the robots to rest on their path and hold them", "the robots come to rest and hold", {}, true},
    OperatorVerb{"resume", "Continue a paused task", "the task continues", {}, true},
    OperatorVerb{"trigger",
                 "Give the task one trigger; it waits for it in a condition",
                 "the task has received a trigger",
                 {},
                 true},
    OperatorVerb{"speed", "Scale the speed of the task's motions along their paths, until it is changed again",
                 "the motions change to this speed", kSpeedArguments, true},
    OperatorVerb{"answer", "Answer a question of the task or of a sensor", "the answer is given", kAnswerArguments,
                 true},
    OperatorVerb{"jog", "Move a robot that no task commands, for 0.2 s; again in time, it continues", "the robot jogs",
                 kJogArguments, true},
    OperatorVerb{"step", "Move a robot that no task commands by a distance", "the robot has arrived", kStepArguments,
                 true, true},
    OperatorVerb{"go", "Move a robot that no task commands to a named posture", "the robot has arrived", kGoArguments,
                 true, true},
    OperatorVerb{"hold", "End a jog, a step or a go: the robot comes to rest", "the robot comes to rest",
                 kRobotArguments, true},
    OperatorVerb{"follow", "Let a robot that its task yields (External) follow a trajectory of joints",
                 "the robot has arrived", kFollowArguments, true, true},
    OperatorVerb{"cancel", "End the trajectory that a robot follows: the robot comes to rest on it",
                 "the trajectory ends", kRobotArguments, true},
    OperatorVerb{"synchronise", "Find the absolute positions of a robot's motors", "the robot is synchronised",
                 kRobotArguments, true, true},
    OperatorVerb{"recover", "Clear a robot's fault and switch its drives on", "the drives are on", kRobotArguments,
                 true, true},
    OperatorVerb{"bias", "Take the present reading of a robot's force sensor as zero", "the force sensor is zeroed",
                 kRobotArguments, true},
    OperatorVerb{"output", "Set one output of a robot's controller", "the output is set", kOutputArguments, true},
    OperatorVerb{"tool", "Change the tool frame to which poses of a robot refer", "the tool frame is changed",
                 kToolArguments, true},
    OperatorVerb{
        "record",
        "Write the last steps of the tasks on the runner's machine to a file, as a black box, while the run continues",
        "", kRecordArguments, false},
    OperatorVerb{
        "stop", "Bring the robots to rest and end the run", "the robots come to rest, then the run ends", {}, false},
    OperatorVerb{"estop",
                 "Emergency stop: every robot brakes at once and stays stopped until 'reset'",
                 "every robot brakes and stays stopped until 'reset'",
                 {},
                 false},
    OperatorVerb{"reset",
                 "Release the emergency stop; no robot moves because of it",
                 "the emergency stop is released",
                 {},
                 true}};

}  // namespace

std::span<const OperatorVerb> operator_verbs() noexcept { return kVerbs; }

const OperatorVerb* find_verb(std::string_view name) noexcept {
  const auto named = [name](const OperatorVerb& verb) { return verb.name == name; };
  const auto found = std::find_if(std::begin(kVerbs), std::end(kVerbs), named);
  return found == std::end(kVerbs) ? nullptr : &*found;
}

std::string nearest_verb(std::string_view name) {
  std::vector<std::string> names;
  for (const OperatorVerb& verb : kVerbs) names.emplace_back(verb.name);
  return core::nearest_word(name, names);
}

std::string usage_of(const OperatorVerb& verb) {
  std::string usage{verb.name};
  for (const VerbArgument& argument : verb.arguments) {
    std::string word{argument.name};
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
    usage += argument.required ? " " + word : " [" + std::string{argument.name} + "=" + word + "]";
  }
  return usage;
}

}  // namespace mrroc::cli
