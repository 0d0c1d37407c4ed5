#include "recording/last_steps.hpp"

#include <algorithm>
#include <utility>

#include "config/clock_names.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "messages/mrroc_msgs/step.hpp"
#include "recording/recording_writer.hpp"

namespace mrroc::recording {

namespace {

/// A simulated clock may differ from the deployment's: for the rules of a trace they are equivalent.
const char* clock_of(const config::Deployment& deployment, bool simulated) noexcept {
  const bool differs = simulated && deployment.clock == config::ClockMode::real;
  return config::name_of(!simulated ? config::ClockMode::real
                         : differs  ? config::ClockMode::lockstep
                                    : deployment.clock);
}

/// Whether the process could not write the whole step. A step that cannot be read is whole, and refused by readers.
bool is_cut(const RecordedStep& step) try {
  return messages::from_cdr<messages::mrroc_msgs::Step>(step.cdr).cut;
} catch (const messages::CdrError&) {
  return false;
}

}  // namespace

int write_last_steps(int fd, const LastSteps& steps, const config::Deployment& deployment, bool simulated,
                     const std::string& text) {
  RecordingWriter::Metadata metadata = metadata_of(deployment);
  metadata["clock"] = clock_of(deployment, simulated);
  metadata[kBlackBox] = "yes";
  RecordingWriter writer(fd, deployment.servo_period, std::move(metadata), text);
  std::vector<std::pair<const RecordedStep*, const std::string*>> sorted;
  for (const auto& [process, own] : steps)
    for (const RecordedStep& step : own) sorted.emplace_back(&step, &process);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first->tick < b.first->tick; });
  for (const auto& [step, process] : sorted) writer.write_step(*process, step->tick, step->cdr);
  for (const auto& [process, own] : steps) {
    messages::mrroc_msgs::ProcessEnd end;
    end.process = process;
    end.steps = own.size();
    end.cut = static_cast<std::uint64_t>(std::count_if(own.begin(), own.end(), is_cut));
    end.stamp = stamp_of(own.empty() ? 0 : own.back().tick, writer.period());
    writer.write(kEndTopic, sorted.empty() ? 0 : sorted.back().first->tick, end);
  }
  return writer.close();
}

}  // namespace mrroc::recording
