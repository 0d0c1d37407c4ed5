#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/run/watch/heartbeat.hpp"
#include "config/deployment.hpp"
#include "recording/recorded_step.hpp"

/// The protocol between `mrroc run` and `mrroc agent`, its helper on another host: lines of a word and its text.
///
///     runner: an order, then `start EPOCH_NS` (of the agent's clock), then `stop`
///     agent:  `mrroc-agent 2 VERSION`, `beat PORT`, `missing NAMES` (those not ready; empty at last), `started`,
///             `line PROCESS TEXT`, `lost PROCESS EXIT_CODE HOW`, `failed EXIT_CODE REASON`, `step PROCESS STEP`,
///             `steps_end PROCESS ADDED DROPPED`, `last_step PROCESS STEP`, `ended`; STEP is to_text of a step
///
/// The end of a stream means that its sender has ended.
namespace mrroc::cli {

/// The first word, the version of the protocol and that of MRROC++.
inline constexpr std::string_view kAgentGreeting = "mrroc-agent 2 " MRROC_VERSION;

/// The order that an agent receives before it starts anything.
struct AgentOrder {
  std::string host;                                        ///< its name in the deployment
  std::filesystem::path deployment;                        ///< the deployment file there
  std::vector<std::pair<std::string, std::string>> files;  ///< the deployment's files and their hashes here
  int domain = 0;                                          ///< DDS domain
  std::vector<std::string> machines;                       ///< addresses of all, the runner's first
  int beat_port = 0;                                       ///< of the runner
  HeartbeatKey key{};
  bool record = false;           ///< the agent sends the steps of its tasks
  bool black_box = false;        ///< the agent sends their last steps
  std::filesystem::path motion;  ///< file there for the motion of the simulated world's robots; empty: none

  bool operator==(const AgentOrder&) const = default;
};

std::vector<std::string> to_lines(const AgentOrder& order);
/// Parses an order from its lines, without the last one, `go`. Throws std::runtime_error that names what is wrong.
AgentOrder order_of_lines(const std::vector<std::string>& lines);

/// "TICK HEX": a step in hexadecimal digits.
std::string to_text(const recording::RecordedStep& step);
/// The step; nothing when the text is not one.
std::optional<recording::RecordedStep> step_of(const std::string& text);

/// The first word of a line, and the rest after one space.
std::pair<std::string, std::string> split_word(const std::string& line);

/// The whole text as a number; nothing when it is not a number.
std::optional<std::int64_t> whole_number(const std::string& text);

/// Key and path of the files that the deployment names, and of itself.
std::vector<std::pair<std::string, std::filesystem::path>> input_files(const config::Deployment& deployment);

/// Key and hash of every file that must be the same on all machines: the deployment itself, the scene, the state
/// machine, the robots' parameters and tables of drives, the files of replayed sensors. Throws ConfigurationError when
/// one cannot be read.
std::vector<std::pair<std::string, std::string>> files_of(const config::Deployment& deployment);

}  // namespace mrroc::cli
