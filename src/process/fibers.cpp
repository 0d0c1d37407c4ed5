#include "process/fibers.hpp"

#include <algorithm>
#include <semaphore>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "mrroc/errors.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::process {

namespace {

bool is_stop(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const Stopped&) {
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace

/// `go` passes the turn to the fiber and `done` passes it back: each thread sees the writes of the previous one.
struct FiberScheduler::Fiber {
  std::binary_semaphore go{0}, done{0};
  clock::Wake wake = clock::Wake::mail;  // the reason why its wait ends
  Tick wake_tick = kNever;               // of its wait
  bool ended = false;
  bool unused = false;  // another one could not be made
  std::exception_ptr error;
  std::jthread thread;  // last: it is joined before the others go
};

FiberScheduler::~FiberScheduler() = default;

void FiberScheduler::run(const std::vector<std::function<void()>>& bodies) {
  if (running_ != nullptr)
    throw NonFatalError(ErrorCode::invalid_argument, "a fiber cannot have fibers: give them all to one call");
  std::vector<std::unique_ptr<Fiber>> fibers;
  try {
    for (const auto& body : bodies) {
      Fiber& fiber = *fibers.emplace_back(std::make_unique<Fiber>());
      fiber.thread = std::jthread([&fiber, &body] {
        fiber.go.acquire();
        if (fiber.unused) return;
        try {
          body();
        } catch (...) {
          fiber.error = std::current_exception();
        }
        fiber.ended = true;
        fiber.done.release();
      });
    }
  } catch (const std::system_error& error) {
    for (const auto& fiber : fibers) {
      fiber->unused = true;
      fiber->go.release();
    }
    throw SystemError(ErrorCode::resources, "a thread for a part of the task: " + std::string{error.what()});
  }
  error_ = nullptr;
  take_turns(fibers);
  cancelled_ = false;
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void FiberScheduler::take_turns(std::vector<std::unique_ptr<Fiber>>& fibers) {
  clock::Wake wake = clock::Wake::mail;
  for (;;) {
    progress_ = false;
    for (const auto& fiber : fibers) {
      if (fiber->ended) continue;
      const bool due = wake != clock::Wake::interrupted && clock_->tick() >= fiber->wake_tick;
      give_turn(*fiber, due ? clock::Wake::tick : wake);
    }
    Tick next = kNever;
    bool all_ended = true;
    for (const auto& fiber : fibers) {
      if (fiber->ended) continue;
      all_ended = false;
      next = std::min(next, fiber->wake_tick);
    }
    if (all_ended) return;
    if (!progress_) wake = clock_->wait(next);
  }
}

void FiberScheduler::give_turn(Fiber& fiber, clock::Wake wake) {
  fiber.wake = wake;
  running_ = &fiber;
  fiber.go.release();
  fiber.done.acquire();
  running_ = nullptr;
  if (fiber.ended) note_progress();
  if (!fiber.error) return;
  if (!error_ || (is_stop(error_) && !is_stop(fiber.error))) error_ = fiber.error;
  fiber.error = nullptr;
  cancelled_ = true;
}

clock::Wake FiberScheduler::wait(Tick wake_tick) {
  if (running_ == nullptr) return clock_->wait(wake_tick);
  Fiber& fiber = *running_;
  if (fiber.wake_tick != wake_tick) note_progress();
  fiber.wake_tick = wake_tick;
  fiber.done.release();
  fiber.go.acquire();
  return fiber.wake;
}

}  // namespace mrroc::process
