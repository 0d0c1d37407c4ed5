#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "messages/mrroc_msgs/step.hpp"
#include "recording/recorded_step.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::record {

/// Writes what one step contains to the topics of a recording: /PROCESS/steps, and, in standard messages, what is new
/// in it: /ROBOT/joint_states of each robot, /ROBOT/wrench where its EDP has a force sensor, and /SENSOR/wrench of each
/// sensor of forces. Several processes report the same state; it is written once. The joint states of
/// robots whose servo ticks are recorded are written by ServoTopics. One thread.
class StepTopics {
 public:
  /// `file` must outlive it. Throws config::ConfigurationError: a robot's parameter file is invalid.
  StepTopics(recording::RecordingWriter& file, const config::Deployment& deployment, bool servo_ticks);
  /// `step`: what `recorded` contains.
  void write(const messages::mrroc_msgs::Step& step, recording::RecordedStep recorded);

 private:
  void write_robot(const messages::mrroc_msgs::RobotState& robot, Tick tick);
  void write_wrench(const std::string& name, const std::string& frame, const std::vector<double>& values, Tick measured,
                    Tick tick);
  /// Whether a value measured at this tick is the first of its topic, or newer than the last one.
  bool is_new(const std::string& topic, Tick measured);

  recording::RecordingWriter& file_;
  const bool joint_states_;
  std::set<std::string> wrench_sensors_;
  std::map<std::string, std::vector<std::string>> joints_;  // names, by robot
  std::map<std::string, Tick> newest_;                      // by topic
};

}  // namespace mrroc::cli::record
