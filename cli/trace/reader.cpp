#include "cli/trace/reader.hpp"

#include <stdexcept>

#include "cli/trace/step_line.hpp"
#include "config/clock_names.hpp"
#include "core/number_text.hpp"
#include "core/shown_text.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::cli::trace {

namespace {

using EndMessage = messages::mrroc_msgs::ProcessEnd;
using StepMessage = messages::mrroc_msgs::Step;

}  // namespace

Reader::Reader(const std::filesystem::path& file) : path_(file), recording_(file) {
  const auto& metadata = recording_.metadata();
  const auto clock = metadata.find("clock");
  const std::string name = clock == metadata.end() ? "" : clock->second;
  if (!config::clock_named(name))
    throw std::runtime_error(file.string() + ": metadata clock: '" + core::shown(name) +
                             "', expected real, paced or lockstep");
  const auto period = metadata.find("servo_period");
  const auto seconds = period == metadata.end() ? std::nullopt : core::to_double(period->second);
  if (!seconds || !(*seconds > 1e-9))
    throw std::runtime_error(file.string() + ": metadata servo_period: '" +
                             core::shown(period == metadata.end() ? "" : period->second) + "', expected seconds");
  period_ = recording::nanoseconds_of(*seconds);
  simulated_ = name != "real";
  last_seconds_ = metadata.contains(recording::kLast);
  black_box_ = last_seconds_ || metadata.contains(recording::kBlackBox);
}

std::variant<std::monostate, Line, ProcessEnd> Reader::next() {
  while (const auto message = recording_.next()) try {
      ++number_;
      if (message->type == StepMessage::kType) {
        Line line = to_line(messages::from_cdr<StepMessage>(message->cdr));
        line.number = number_;
        line.made = message->time / period_;
        ++steps_[line.process];
        empty_ = false;
        return line;
      }
      if (message->type == EndMessage::kType) {
        empty_ = false;
        return end_of(*message);
      }
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path_.string() + ":" + std::to_string(number_) + ": " + error.what());
    }
  if (empty_) throw NoSteps(path_);
  return {};
}

ProcessEnd Reader::end_of(const recording::RecordedMessage& message) const {
  const auto read = messages::from_cdr<EndMessage>(message.cdr);
  const auto found = steps_.find(read.process);
  ProcessEnd end;
  end.number = number_;
  end.process = read.process;
  // of the last seconds the recording has fewer than the process has made
  end.lines = !last_seconds_ ? read.steps : found == steps_.end() ? 0 : found->second;
  end.dropped = read.dropped;
  end.cut = read.cut;
  return end;
}

}  // namespace mrroc::cli::trace
