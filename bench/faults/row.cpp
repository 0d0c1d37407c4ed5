#include "faults/row.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "faults/campaign.hpp"

namespace mrroc::faults_bench {

namespace {

/// The output of a run about the error, without the line that reports the injection, which may contain the words of an
/// error.
std::string said_of_the_error(std::string output) {
  if (const std::size_t place = output.find("injected at tick "); place != std::string::npos)
    output.erase(place, output.find('\n', place) - place);
  return output;
}

/// The smallest "tick <number>" in a text that is not before `first`: the tick of the detection.
std::optional<Tick> tick_in(const std::string& text, Tick first) {
  std::optional<Tick> found;
  for (std::size_t place = text.find("tick "); place != std::string::npos; place = text.find("tick ", place + 1)) {
    const Tick tick = std::strtoull(text.c_str() + place + 5, nullptr, 10);
    if (tick >= first) found = found ? std::min(*found, tick) : tick;
  }
  return found;
}

/// "hardware error: the following error is too large", "process arm died": the first in the text, without the part that
/// belongs to one case.
std::string kind_of_error(const std::string& text) {
  std::size_t place = std::string::npos;
  for (const char* beginning : {"non-fatal error: ", "hardware error: ", "system error: ", "process "})
    place = std::min(place, text.find(beginning));
  if (place == std::string::npos) return "";
  const std::string line = text.substr(place, text.find('\n', place) - place);
  const std::size_t colon = line.find(": ");
  if (line.starts_with("process ")) return line.substr(0, std::min(colon, line.find(" by ")));
  return line.substr(0, std::min(line.find(": ", colon + 2), line.find(" [", colon + 2)));
}

/// "Move of arm": the instruction of the process that the error names in its origin, at the tick of its detection.
/// "mrroc run": the runner missed a process.
std::string place_of_error(const std::string& text, const task_test::RunResult& run, Tick detected) {
  constexpr const char* kOrigin = "[process ";
  const std::size_t place = text.find(kOrigin);
  if (place == std::string::npos) return "mrroc run";
  const std::size_t begin = place + std::char_traits<char>::length(kOrigin);
  const std::string process = text.substr(begin, text.find_first_of(",]", begin) - begin);
  const task_test::Step* last = nullptr;
  const std::vector<task_test::Step> steps = run.steps_of(process);
  for (const task_test::Step& step : steps)
    if (step.tick <= detected) last = &step;
  if (last == nullptr) return process;
  return (last->is_move ? "Move of " : "Wait of ") + process;
}

std::string figures(std::vector<Tick> ticks) {
  if (ticks.empty()) return "-";
  std::sort(ticks.begin(), ticks.end());
  return std::to_string(ticks[ticks.size() / 2]).append(" / ").append(std::to_string(ticks.back()));
}

/// The text, or each text with its number when there are several, most frequent first.
std::string counted(const std::map<std::string, std::size_t>& runs) {
  if (runs.size() == 1) return runs.begin()->first;
  std::vector<std::pair<std::size_t, std::string>> order;
  for (const auto& [text, count] : runs) order.emplace_back(count, text);
  std::sort(order.rbegin(), order.rend());
  std::string all;
  for (const auto& [count, text] : order)
    all.append(all.empty() ? "" : ", ").append(std::to_string(count)).append(" ").append(text);
  return all;
}

}  // namespace

Row::Row(std::string fault) : fault_(std::move(fault)) {}

void Row::add(const task_test::RunResult& run, const std::string& injected) {
  ++runs_;
  exit_codes_.insert(run.exit_code);
  leftovers_ += run.leftovers.size();
  if (run.motion.empty()) ++unseen_;
  for (const auto& [robot, motion] : run.motion) {
    exceeded_ += motion.limits_exceeded(speed_tolerance(fault_)).size();
    fastest_ = std::max(fastest_, motion.fastest());
    if (motion.standstill() == kNever) ++moving_;
  }
  const auto struck = run.injected.find(injected);
  const std::string printed = said_of_the_error(run.output);
  const std::string error = kind_of_error(printed);
  if (struck == run.injected.end() && run.exit_code != 0) {
    ++early_;
    std::fprintf(stderr, "%s: ended before it: %s\n", injected.c_str(), run.output.c_str());
  }
  if (struck == run.injected.end() || (run.exit_code == 0 && error.empty())) {
    ++unaffected_;  // it ended before, or continued in spite of the fault
    return;
  }
  ++(run.exit_code == 0 ? recovered_ : ended_);
  ++errors_[error];
  // a process that dies at the beginning of a tick is missed at once: the newest tick that all have seen is the one
  // before
  const std::optional<Tick> reported = tick_in(printed, struck->second - 1);
  if (!reported) return;
  const Tick detected = std::max(*reported, struck->second);
  detected_.push_back(detected - struck->second);
  ++places_[place_of_error(printed, run, detected)];
  Tick stands = detected;
  for (const auto& [robot, motion] : run.motion) stands = std::max(stands, motion.at_rest(detected));
  if (stands != kNever) standing_.push_back(stands - detected);
}

bool Row::good(bool recovers) const {
  const bool world_ends = fault_.ends_with(" sim");  // with its robots as they moved
  return unseen_ == 0 && early_ == 0 && exceeded_ == 0 && (world_ends || moving_ == 0) && leftovers_ == 0 &&
         (!recovers || ended_ == 0);
}

void Row::print_head() {
  std::printf(
      "| fault | to its detection | then to standstill | fastest, of the limit | beyond the limit | thrown | error | "
      "ended | recovered | unaffected | exit codes | left |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void Row::print() const {
  std::string codes;
  for (const int code : exit_codes_) codes.append(codes.empty() ? "" : " ").append(std::to_string(code));
  std::printf("| %s | %s | %s | %.2f | %zu (%.2f) | %s | %s | %zu | %zu | %zu | %s | %zu |\n", fault_.c_str(),
              figures(detected_).c_str(), figures(standing_).c_str(), fastest_, exceeded_, 1 + speed_tolerance(fault_),
              counted(places_).c_str(), counted(errors_).c_str(), ended_, recovered_, unaffected_, codes.c_str(),
              leftovers_);
  std::fflush(stdout);
}

}  // namespace mrroc::faults_bench
