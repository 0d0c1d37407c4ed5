#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "cli/record/recording_writer.hpp"
#include "cli/trace/line.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli::record {

/// Writes what one step contains to the topics of a recording: /PROCESS/steps, and, in standard messages, what is new
/// in it: /ROBOT/joint_states of each robot, /ROBOT/wrench where its EDP has a force sensor, and /SENSOR/wrench of each
/// sensor of forces. Several processes report the same state; it is written once. The joint states of
/// robots whose servo ticks are recorded are written by ServoTopics. One thread.
class StepTopics {
 public:
  /// `file` must outlive it. Throws config::ConfigurationError: a robot's parameter file is invalid.
  StepTopics(RecordingWriter& file, const config::Deployment& deployment, bool servo_ticks);
  /// `tick`: at which the step was made; messages have it as their time.
  void write(const trace::Line& line, Tick tick);

 private:
  void write_robot(const trace::RobotEntry& robot, Tick tick);
  void write_wrench(const std::string& name, const std::string& frame, const trace::Numbers& values, Tick measured,
                    Tick tick);
  /// Whether a value measured at this tick is the first of its topic, or newer than the last one.
  bool is_new(const std::string& topic, Tick measured);

  RecordingWriter& file_;
  const bool joint_states_;
  std::set<std::string> wrench_sensors_;
  std::map<std::string, std::vector<std::string>> joints_;  // names, by robot
  std::map<std::string, Tick> newest_;                      // by topic
};

}  // namespace mrroc::cli::record
