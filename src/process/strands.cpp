#include "process/strands.hpp"

#include <algorithm>
#include <semaphore>
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

/// `go` passes the turn to the strand and `done` passes it back: each thread sees the writes of the previous one.
struct StrandClock::Strand {
  std::binary_semaphore go{0}, done{0};
  clock::Wake wake = clock::Wake::mail;  // the reason why its wait ends
  Tick wake_tick = kNever;               // of its wait
  bool ended = false;
  std::exception_ptr error;
  std::jthread thread;  // last: it is joined before the others go
};

StrandClock::~StrandClock() = default;

void StrandClock::run(const std::vector<std::function<void()>>& bodies) {
  if (running_ != nullptr)
    throw NonFatalError(ErrorCode::invalid_argument, "a strand cannot have strands: give them all to one call");
  std::vector<std::unique_ptr<Strand>> strands;
  for (const auto& body : bodies) {
    Strand& strand = *strands.emplace_back(std::make_unique<Strand>());
    strand.thread = std::jthread([&strand, &body] {
      strand.go.acquire();
      try {
        body();
      } catch (...) {
        strand.error = std::current_exception();
      }
      strand.ended = true;
      strand.done.release();
    });
  }
  error_ = nullptr;
  take_turns(strands);
  cancelled_ = false;
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void StrandClock::take_turns(std::vector<std::unique_ptr<Strand>>& strands) {
  clock::Wake wake = clock::Wake::mail;
  for (;;) {
    progress_ = false;
    for (const auto& strand : strands) {
      if (strand->ended) continue;
      const bool due = wake != clock::Wake::interrupted && clock_->tick() >= strand->wake_tick;
      give_turn(*strand, due ? clock::Wake::tick : wake);
    }
    Tick next = kNever;
    bool all_ended = true;
    for (const auto& strand : strands) {
      if (strand->ended) continue;
      all_ended = false;
      next = std::min(next, strand->wake_tick);
    }
    if (all_ended) return;
    if (!progress_) wake = clock_->wait(next);
  }
}

void StrandClock::give_turn(Strand& strand, clock::Wake wake) {
  strand.wake = wake;
  running_ = &strand;
  strand.go.release();
  strand.done.acquire();
  running_ = nullptr;
  if (strand.ended) note_progress();
  if (!strand.error) return;
  if (!error_ || (is_stop(error_) && !is_stop(strand.error))) error_ = strand.error;
  strand.error = nullptr;
  cancelled_ = true;
}

clock::Wake StrandClock::wait(Tick wake_tick) {
  if (running_ == nullptr) return clock_->wait(wake_tick);
  Strand& strand = *running_;
  if (strand.wake_tick != wake_tick) note_progress();
  strand.wake_tick = wake_tick;
  strand.done.release();
  strand.go.acquire();
  return strand.wake;
}

}  // namespace mrroc::process
