#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "edp/servo/servo_sample.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::record {

/// Writes every servo tick of the robots to a recording: /ROBOT/servo, and in standard messages /ROBOT/joint_states
/// with positions and velocities, and /ROBOT/servo_wrench, in the frame of its force sensor, where it has one. One
/// thread.
class ServoTopics {
 public:
  /// `file` must outlive it. Throws config::ConfigurationError: a robot's parameter file is invalid.
  ServoTopics(recording::RecordingWriter& file, const config::Deployment& deployment);
  /// A sample of this robot's servo, of which a damaged process may have written every value.
  void write(const std::string& robot, const edp::ServoSample& sample);

 private:
  struct Robot {
    std::vector<std::string> joints;  ///< their names
    std::string force_sensor;         ///< empty: it has none
  };

  recording::RecordingWriter& file_;
  std::map<std::string, Robot> robots_;  // by name
};

}  // namespace mrroc::cli::record
