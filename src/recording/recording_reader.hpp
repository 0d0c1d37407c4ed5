#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mrroc::recording {

/// A message of a recording.
struct RecordedMessage {
  std::string topic;
  std::string type;            ///< "mrroc_msgs/msg/Step"
  std::uint64_t time = 0;      ///< ns since tick 0
  std::vector<std::byte> cdr;  ///< its encoding
};

/// What every MCAP file begins with.
inline constexpr std::string_view kBeginning{"\x89MCAP0\r\n", 8};

/// Whether the file begins as every MCAP file does. False for a file that cannot be read.
bool is_recording(const std::filesystem::path& file);

/// Reads the recording of a run (`mrroc run --record`) from its beginning, chunk by chunk, without its index: also that
/// of a run that was killed. Memory does not grow with its length, and no length in it is believed before the bytes are
/// there. One thread.
class RecordingReader {
 public:
  /// Throws std::runtime_error "FILE: ..." when the file cannot be read, or is not a recording of a run.
  explicit RecordingReader(const std::filesystem::path& file);
  ~RecordingReader();
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;

  /// version, deployment, clock, servo_period (s).
  const std::map<std::string, std::string>& metadata() const noexcept;
  /// The next message, in the order of the file; nothing at the end. Throws std::runtime_error "FILE: byte N: ...".
  std::optional<RecordedMessage> next();
  /// At the end: the run has closed the file. False: it was killed, or the disk was full.
  bool complete() const noexcept;

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace mrroc::recording
