#pragma once

#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {

/// The VSP's end of a robot's `StateFeed`: the state e_l of the robot that its sensor is mounted on. Topics:
/// `<prefix>/<sensor>/state`, and `<prefix>/<sensor>/follow` for the hand-shake. The participant's thread calls it.
class StateFollower {
 public:
  /// `prefix`: "<deployment>/<robot>"; `sensor`: name of the sensor; `peer`: the EDP's name, for errors.
  StateFollower(Domain& domain, clock::Clock& clock, const std::string& prefix, const std::string& sensor,
                std::string peer);

  /// Hand-shake with the EDP, about `timeout` s at most; before the clock starts. Throws as links::connect.
  void connect(double timeout);

  /// The oldest state not yet taken; false when there is none. Neither waits, locks nor allocates.
  bool take(RobotState& state) {
    Header header;
    return state_.take(state, header);
  }

 private:
  std::string peer_;
  Writer<SensorRequest> handshake_;
  Reader<RobotState> state_;
};

}  // namespace mrroc::links
