#include "sim/scene/mujoco_messages.hpp"

#include <mujoco/mujoco.h>

namespace mrroc::sim {

namespace {

thread_local MujocoMessages* innermost = nullptr;

void throw_message(const char* message) { throw MujocoError(message); }

}  // namespace

void MujocoMessages::collect(const char* message) {
  if (innermost != nullptr) innermost->warnings_.emplace_back(message);
}

MujocoMessages::MujocoMessages() : outer_(innermost) {
  // the handlers are the same for all threads and stay: set once
  [[maybe_unused]] static const bool installed = [] {
    mju_user_error = throw_message;
    mju_user_warning = collect;
    return true;
  }();
  innermost = this;
}

MujocoMessages::~MujocoMessages() { innermost = outer_; }

}  // namespace mrroc::sim
