#include "mrroc/generators/together.hpp"

#include <algorithm>

namespace mrroc {

std::string Together::joined(const std::vector<const Generator*>& parts) {
  std::string name;
  for (const Generator* part : parts) name += (name.empty() ? "" : " + ") + part->name();
  return name;
}

void Together::start() {
  for (Part& part : parts_) {
    part.ended = false;
    if (part.generator->condition()) part.generator->condition()->start();
    part.generator->start();
  }
}

void Together::resume() {
  for (Part& part : parts_)
    if (!part.ended) part.generator->resume();
}

bool Together::brake() {
  bool all = true;
  for (Part& part : parts_)
    if (!part.ended && !part.generator->brake()) all = false;  // those that could are resumed with the others
  return all;
}

bool Together::terminal_condition() {
  for (Part& part : parts_) {
    if (part.ended) continue;
    const bool condition = part.generator->condition() && part.generator->condition()->evaluate();
    part.ended = part.generator->terminal_condition() || condition;
  }
  return std::all_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.ended; });
}

bool Together::scales_with_speed() const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [](const Part& part) { return part.generator->scales_with_speed(); });
}

void Together::next_state() {
  for (Part& part : parts_)
    if (!part.ended) part.generator->next_state();
}

void Together::finish() noexcept {
  for (Part& part : parts_) part.generator->finish();
}

}  // namespace mrroc
