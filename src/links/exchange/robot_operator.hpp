#pragma once

#include <cstdint>
#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::links {

/// The operator's end of a link to an EDP, which answers with a `RobotResponder`: topics `<prefix>/command` and
/// `<prefix>/state`. It never waits for the robot. `send` and `take` may be called by two threads, each by one.
class RobotOperator {
 public:
  /// `prefix`: "<deployment>/<robot>/operator"; `peer`: the EDP's name, for errors.
  RobotOperator(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer);

  /// Hand-shake with the EDP, about `timeout` s at most; before the clock starts. Throws as links::connect.
  void connect(double timeout);

  /// Sends a command and returns its number (1, 2, ...). Throws SystemError when DDS refuses it.
  std::uint64_t send(const RobotCommand& command);
  /// The oldest reply not yet taken, and the number of its command. Neither waits, locks nor allocates.
  bool take(RobotState& state, std::uint64_t& number);

 private:
  const std::string peer_;
  const std::uint64_t boot_;
  Writer<RobotCommand> writer_;
  Reader<RobotState> reader_;
  std::uint64_t sent_ = 0;
};

}  // namespace mrroc::links
