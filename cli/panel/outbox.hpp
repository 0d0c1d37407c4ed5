#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace mrroc::cli {

/// What one browser is to be sent: lines in order, and of states the newest of each kind. Bounded: a browser that is
/// read too slowly is reported by `overflowed`. Any thread.
class Outbox {
 public:
  static constexpr std::size_t kMaxBytes = 1 << 20;

  /// A line that must not be lost.
  void add(const std::string& line) {
    const std::lock_guard lock(mutex_);
    bytes_ += line.size();
    if (bytes_ <= kMaxBytes) lines_.push_back(line);
  }
  /// A state; it replaces the last one of its kind that has not been taken.
  void replace(const std::string& kind, const std::string& line) {
    const std::lock_guard lock(mutex_);
    states_[kind] = line;
  }
  /// All that there is: the lines, then the states.
  std::vector<std::string> take() {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> taken(lines_.begin(), lines_.end());
    for (auto& [kind, line] : states_) taken.push_back(std::move(line));
    lines_.clear();
    states_.clear();
    if (bytes_ <= kMaxBytes) bytes_ = 0;
    return taken;
  }
  /// Whether a line has been lost.
  bool overflowed() const {
    const std::lock_guard lock(mutex_);
    return bytes_ > kMaxBytes;
  }

 private:
  mutable std::mutex mutex_;
  std::deque<std::string> lines_;
  std::map<std::string, std::string> states_;
  std::size_t bytes_ = 0;  ///< of the lines
};

}  // namespace mrroc::cli
