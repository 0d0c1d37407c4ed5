#pragma once

#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {

/// The EDP's end of one sensor's `StateFollower`: carries the state e_l of the robot to the VSP, at every servo tick,
/// and answers the hand-shake automatically. The participant's thread calls it, never a servo thread.
class StateFeed {
 public:
  /// `prefix`: "<deployment>/<robot>"; `sensor`: name of the sensor. Throws as `Writer`.
  StateFeed(Domain& domain, clock::Clock& clock, const std::string& prefix, const std::string& sensor);

  /// Sends a state; never waits. Throws SystemError (link_lost) when DDS refuses it.
  void send(const RobotState& state) { state_.write(state, ++sent_); }

 private:
  Writer<RobotState> state_;
  Reader<SensorRequest> handshake_;
  std::uint64_t sent_ = 0;
};

}  // namespace mrroc::links
