#include "cli/processes/process_group.hpp"

#include <poll.h>
#include <signal.h>

#include <algorithm>

namespace mrroc::cli {

void ProcessGroup::start(const PlannedProcess& process, const std::vector<std::string>& arguments,
                         const std::vector<int>& handed) {
  members_.push_back({Child(process.name, process.program.string(), arguments, -1, handed), process.part});
}

const Child* ProcessGroup::find(const std::string& name) const noexcept {
  for (const Member& member : members_)
    if (member.child.name() == name) return &member.child;
  return nullptr;
}

void ProcessGroup::wait(int milliseconds, std::initializer_list<int> also) {
  std::vector<pollfd> descriptors;
  for (const int fd : also) descriptors.push_back({fd, POLLIN, 0});
  for (Member& member : members_) {
    // the pipe of a process that has ended stays readable: polling it would not wait
    descriptors.push_back({member.child.ended() ? -1 : member.child.output_fd(), POLLIN, 0});
  }
  poll(descriptors.data(), descriptors.size(), milliseconds);
  for (Member& member : members_) listen(member.child);
}

Child* ProcessGroup::first_lost(const std::vector<std::string>& suspects) {
  if (std::none_of(members_.begin(), members_.end(), [](Member& member) { return member.child.lost(); }))
    return nullptr;
  // a process that leaves because another has died may be seen before that one, so all are checked again
  const auto blame = [&suspects](Child& child) {
    if (!child.lost()) return -1;
    if (std::find(suspects.begin(), suspects.end(), child.name()) != suspects.end()) return 2;
    return child.exit_code() != 0 ? 1 : 0;
  };
  Child* found = nullptr;
  for (Member& member : members_)
    if (blame(member.child) > (found == nullptr ? -1 : blame(*found))) found = &member.child;
  if (found != nullptr) listen(*found);
  return found;
}

bool ProcessGroup::all_ended() noexcept {
  return std::all_of(members_.begin(), members_.end(), [](Member& member) { return member.child.ended(); });
}

std::vector<Child*> ProcessGroup::failed(clock::Part part) {
  std::vector<Child*> found;
  for (Member& member : members_)
    if (member.part == part && member.child.lost() && member.child.exit_code().value_or(-1) != 0)
      found.push_back(&member.child);
  for (Child* const child : found) listen(*child);
  return found;
}

bool ProcessGroup::all_left(clock::Part part, const clock::ClockHost& clock) noexcept {
  return std::all_of(members_.begin(), members_.end(), [part, &clock](Member& member) {
    return member.part != part || member.child.lost() || clock.has_left(member.child.name());
  });
}

void ProcessGroup::signal(int number) noexcept {
  for (Member& member : members_) member.child.signal(number);
}

void ProcessGroup::signal(int number, clock::Part part) noexcept {
  for (Member& member : members_)
    if (member.part == part) member.child.signal(number);
}

std::vector<std::string> ProcessGroup::kill_stopped() noexcept {
  return kill_those([](Child& child) { return child.lost(); });
}

std::vector<std::string> ProcessGroup::kill_rest() noexcept {
  return kill_those([](Child&) { return true; });
}

template <class Predicate>
std::vector<std::string> ProcessGroup::kill_those(Predicate predicate) noexcept {
  std::vector<std::string> names;
  for (Member& member : members_) {
    if (member.child.ended() || !predicate(member.child)) continue;
    names.push_back(member.child.name());
    member.child.signal(SIGKILL);
  }
  return names;
}

void ProcessGroup::listen(Child& child) {
  for (const std::string& line : child.read_lines()) listener_(child.name(), line);
}

}  // namespace mrroc::cli
