#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "messages/diagnostic_msgs/diagnostic_array.hpp"

namespace mrroc::cli {

/// The states of a run's processes and robots as `diagnostic_msgs` has them: one status each, by name. One thread.
class Diagnostics {
 public:
  explicit Diagnostics(std::string deployment) : deployment_(std::move(deployment)) {}

  /// Takes an event "process" or "robot".
  void take(const nlohmann::ordered_json& event);
  messages::diagnostic_msgs::DiagnosticArray message(const messages::builtin_interfaces::Time& stamp) const;

 private:
  std::string deployment_;
  std::map<std::string, messages::diagnostic_msgs::DiagnosticStatus> states_;
};

}  // namespace mrroc::cli
