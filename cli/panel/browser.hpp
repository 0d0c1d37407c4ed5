#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <thread>

#include "cli/operator/socket/run_connection.hpp"
#include "cli/panel/beat.hpp"
#include "cli/panel/outbox.hpp"
#include "cli/panel/panel_access.hpp"

namespace mrroc::cli {

/// One browser that shows the panel. It is a client of the run by a connection of its own: it holds command for itself,
/// and what it sends reaches the run only as fast as the run reads. Its writer is a thread of its own: a browser that
/// does not read delays no other browser.
class Browser {
 public:
  /// Sends one message; false when the browser is gone. It may wait.
  using Send = std::function<bool(const std::string& message)>;

  /// Throws std::runtime_error when the run does not answer. `beat` outlives it.
  Browser(const std::filesystem::path& run, PanelRight right, const Beat& beat, Send send);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Executes a message of the browser. Thread of its connection.
  void receive(std::string_view message);
  /// Any thread.
  void publish(const std::string& line);
  void publish_state(const std::string& kind, const std::string& line);
  /// The run's name of this client.
  const std::string& client() const noexcept { return run_.client(); }
  const std::string& deployment() const noexcept { return run_.deployment(); }
  int pid() const noexcept { return run_.pid(); }

 private:
  void write();
  void wake() noexcept;

  RunConnection run_;
  PanelRight right_;
  const Beat& beat_;
  Send send_;
  Outbox outbox_;
  int wake_ = -1;
  std::atomic<bool> ended_{false};
  std::thread writer_;
};

}  // namespace mrroc::cli
