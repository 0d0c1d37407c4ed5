#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace mrroc::sim {

/// An error from MuJoCo's error handler (the default one would wait for a key on stdin and exit).
class MujocoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While it lives, MuJoCo's errors of this thread are thrown as MujocoError and its warnings are collected here
/// instead of in MUJOCO_LOG.TXT. Nests; the innermost collects. Every call into MuJoCo happens inside one.
class MujocoMessages {
 public:
  MujocoMessages();
  ~MujocoMessages();
  MujocoMessages(const MujocoMessages&) = delete;
  MujocoMessages& operator=(const MujocoMessages&) = delete;

  /// Warnings so far, in order.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

 private:
  static void collect(const char* message);
  MujocoMessages* outer_;
  std::vector<std::string> warnings_;
};

}  // namespace mrroc::sim
