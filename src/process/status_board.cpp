#include "process/status_board.hpp"

#include <chrono>
#include <cstring>
#include <exception>

namespace mrroc::process {

namespace {
constexpr std::chrono::milliseconds kHeartbeat{100};
constexpr int kTurnsPerHeartbeat = 5;  // with telemetry
}  // namespace

StatusBoard::StatusBoard(links::StatusPublisher& publisher, const links::ProcessStatus& first,
                         const clock::Clock& clock)
    : publisher_(publisher), clock_(clock), status_(first), thread_([this] { run(); }) {}

StatusBoard::~StatusBoard() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void StatusBoard::step(std::uint64_t instruction, std::string_view activity, std::uint64_t step) noexcept {
  Activity value;
  value.instruction = instruction;
  value.step = step;
  std::memcpy(value.text, activity.data(), std::min(activity.size(), sizeof(value.text) - 1));
  activity_.store(value);
}

void StatusBoard::counters(const links::Counters& counters) noexcept { counters_.store(counters); }

void StatusBoard::fault(const ErrorReport& fault) noexcept { fault_.store(fault); }

void StatusBoard::also(std::function<void()> publish) {
  const std::lock_guard lock(mutex_);
  also_ = std::move(publish);
}

void StatusBoard::state(links::ProcessState state) {
  const std::lock_guard lock(mutex_);
  status_.state = state;
  publish();
}

void StatusBoard::failed(const ErrorReport& error) {
  const std::lock_guard lock(mutex_);
  status_.state = links::ProcessState::failed;
  status_.error = error;
  publish();
}

void StatusBoard::publish() noexcept try {
  Activity activity;
  if (activity_.load(activity)) {
    status_.instruction = activity.instruction;
    status_.step = activity.step;
    status_.activity.assign(activity.text);
  }
  counters_.load(status_.counters);
  if (status_.state != links::ProcessState::failed) fault_.load(status_.error);
  status_.tick = clock_.tick();
  ++status_.beat;
  publisher_.publish(status_);
} catch (const std::exception&) {
  // do not end a process whose robot moves: the runner detects a missing heartbeat
}

void StatusBoard::run() {
  std::unique_lock lock(mutex_);
  for (int turn = 0; !ended_; ++turn) {
    if (!also_ || turn % kTurnsPerHeartbeat == 0) publish();
    if (also_) also_();
    wake_.wait_for(lock, also_ ? kHeartbeat / kTurnsPerHeartbeat : kHeartbeat);
  }
}

}  // namespace mrroc::process
