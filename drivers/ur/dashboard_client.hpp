#pragma once

#include <string>
#include <string_view>

#include "drivers/ur/tcp_socket.hpp"

namespace mrroc::ur {

/// The dashboard server of a controller with PolyScope 3 or 5: one line of text for each command and each answer. Every
/// method waits for the answer, up to the timeout, and throws ConnectionError without one. Not for the servo thread.
class DashboardClient {
 public:
  /// Connects and takes the greeting. `timeout` in s.
  DashboardClient(const std::string& address, int port, double timeout);

  /// The answer to a command, without its line end.
  std::string ask(std::string_view command);

  /// These return whether the controller accepts the command; `answer` then is its text.
  bool power_on() { return accepts("power on", "Powering on"); }
  bool power_off() { return accepts("power off", "Powering off"); }
  bool release_brakes() { return accepts("brake release", "Brake releasing"); }
  /// The controller refuses it in the first 5 s of a protective stop.
  bool unlock_protective_stop() { return accepts("unlock protective stop", "Protective stop releasing"); }
  /// Removes the window that an emergency or safeguard stop leaves on the teach pendant.
  bool close_safety_popup() { return accepts("close safety popup", "closing safety popup"); }
  bool stop_program() { return accepts("stop", "Stopped"); }

  /// True also where the controller does not have the question: PolyScope before 5.6 has no remote mode.
  bool is_in_remote_control();
  std::string safety_status() { return after_colon(ask("safetystatus")); }
  std::string robot_mode() { return after_colon(ask("robotmode")); }
  std::string program_state() { return ask("programState"); }

  /// Of the last command.
  const std::string& answer() const noexcept { return answer_; }

 private:
  bool accepts(std::string_view command, std::string_view expected);
  static std::string after_colon(const std::string& line);
  std::string take_line();

  TcpSocket socket_;
  double timeout_;
  std::string received_, answer_;
};

}  // namespace mrroc::ur
