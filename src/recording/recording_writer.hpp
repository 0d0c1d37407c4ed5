#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "config/deployment.hpp"
#include "messages/cdr_writer.hpp"
#include "recording/chunked_file.hpp"
#include "recording/recent_messages.hpp"
#include "recording/recorded_time.hpp"

namespace mrroc::recording {

/// Names in a recording.
inline constexpr const char* kMetadata = "mrroc";  ///< version, deployment, clock, servo_period (s), and those below
inline constexpr const char* kLast = "last";       ///< s: the recording has the last seconds of a run only
inline constexpr const char* kBlackBox = "black_box";  ///< the recording has the last steps of its processes only
inline constexpr const char* kDeployment = "deployment.toml";  ///< attachment: the deployment's text, as it was read
inline constexpr const char* kEventTopic = "/events";
inline constexpr const char* kEndTopic = "/process_ends";
inline constexpr const char* kServoEndTopic = "/servo_ends";
inline constexpr const char* kStepTopicEnd = "/steps";  ///< behind "/PROCESS"

/// The metadata of every recording of this deployment.
std::map<std::string, std::string> metadata_of(const config::Deployment& deployment);

/// The recording of one run: an MCAP file that begins with the deployment, and whose chunks are at most a second of the
/// run's time long, so that a killed run leaves all but the last second. With `last` the messages of the last seconds
/// stay in memory, until `save` writes them. One thread; `save`: any.
class RecordingWriter {
 public:
  using Metadata = std::map<std::string, std::string>;

  /// `fd`: an empty file, stays the caller's; not used with `last` (s). `text`: of the deployment.
  RecordingWriter(int fd, const config::Deployment& deployment, const std::string& text,
                  const std::optional<double>& last = {});
  /// With other metadata. `servo_period`: s.
  RecordingWriter(int fd, double servo_period, Metadata metadata, const std::string& text);

  /// Of the servo, ns.
  std::uint64_t period() const noexcept { return period_; }
  bool keeps_last() const noexcept { return recent_.has_value(); }
  /// `tick`: the time of the message; not before that of the last one by more than the recorder's window.
  template <class Message>
  void write(const std::string& topic, Tick tick, const Message& message) {
    write({topic, Message::kType, Message::schema(), time_of(tick, period_), messages::to_cdr(message)});
  }
  /// A step as its process has encoded it, mrroc_msgs/msg/Step.
  void write_step(const std::string& process, Tick tick, std::vector<std::byte> cdr);
  /// Whether nothing is in memory. Any thread.
  bool empty() const;
  /// Writes what is in memory to an empty file. Returns the errno of the first failed write; 0: the file is complete.
  int save(int fd) const;
  /// As save() returns it; 0 when the messages are in memory.
  int close() { return file_ ? file_->close() : 0; }

 private:
  void begin(ChunkedFile& file) const;
  void write(RecentMessages::Message message);
  /// Ends the chunk before a message of a later second than `second`.
  static void add(ChunkedFile& file, std::uint64_t& second, const RecentMessages::Message& message);

  std::uint64_t period_;
  Metadata metadata_;
  std::string text_;
  std::uint64_t second_ = 0;  // of the newest message
  std::optional<ChunkedFile> file_;
  mutable std::mutex mutex_;  // of the one below
  std::optional<RecentMessages> recent_;
};

}  // namespace mrroc::recording
