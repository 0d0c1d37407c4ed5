#include "cli/crew.hpp"

#include <poll.h>
#include <signal.h>

#include <algorithm>

namespace mrroc::cli {

void Crew::start(const std::string& name, const std::string& program, const std::vector<std::string>& arguments) {
  children_.emplace_back(name, program, arguments);
}

void Crew::wait(int milliseconds, int also) {
  std::vector<pollfd> descriptors{{also, POLLIN, 0}};
  for (Child& child : children_) {
    // the pipe of one that has ended stays readable for ever: polling it would not wait
    descriptors.push_back({child.ended() ? -1 : child.output_fd(), POLLIN, 0});
  }
  poll(descriptors.data(), descriptors.size(), milliseconds);
  for (Child& child : children_) listen(child);
}

Child* Crew::first_ended() {
  for (Child& child : children_) {
    if (!child.ended()) continue;
    listen(child);
    return &child;
  }
  return nullptr;
}

bool Crew::all_ended() noexcept {
  return std::all_of(children_.begin(), children_.end(), [](Child& child) { return child.ended(); });
}

void Crew::signal(int number) noexcept {
  for (Child& child : children_) child.signal(number);
}

std::vector<std::string> Crew::kill_rest() noexcept {
  std::vector<std::string> names;
  for (Child& child : children_) {
    if (child.ended()) continue;
    names.push_back(child.name());
    child.signal(SIGKILL);
  }
  return names;
}

void Crew::listen(Child& child) {
  for (const std::string& line : child.read_lines()) listener_(child.name(), line);
}

}  // namespace mrroc::cli
