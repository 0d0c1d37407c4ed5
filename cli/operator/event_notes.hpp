#pragma once

#include <filesystem>
#include <string>

#include "config/deployment.hpp"

namespace mrroc::cli {

/// The commands of a live run as [[events]] of a deployment file, with the ticks at which they took effect:
/// `--note-events`. A lockstep run of the same deployment with `--events` and this file is the same run. Main thread.
class EventNotes {
 public:
  /// `fd`: an empty file that outlives it, not owned; `path`: its name in messages.
  EventNotes(int fd, std::filesystem::path path, const config::Deployment& deployment);
  /// Writes a command. Throws std::runtime_error with the reason when the file does not take it.
  void note(const config::Event& event);

 private:
  int fd_;
  std::filesystem::path path_;
  const config::Deployment& deployment_;
};

/// The text of one event: a table [[events]] and an empty line.
std::string text_of(const config::Event& event, const config::Deployment& deployment);

}  // namespace mrroc::cli
