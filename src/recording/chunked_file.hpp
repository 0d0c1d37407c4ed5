#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace mrroc::recording {

/// An MCAP file of profile `ros2` under construction: every schema is ros2msg, every message CDR. Its bytes depend on
/// the calls alone. After the first failed write nothing more is written, and every call returns at once. Messages are
/// in the file when their chunk is complete. One thread.
class ChunkedFile {
 public:
  /// `fd`: an empty file, stays the caller's.
  explicit ChunkedFile(int fd);
  ~ChunkedFile();
  ChunkedFile(const ChunkedFile&) = delete;
  ChunkedFile& operator=(const ChunkedFile&) = delete;

  void add_metadata(const std::string& name, const std::map<std::string, std::string>& values);
  void add_attachment(const std::string& name, const std::string& media_type, std::string_view content);
  /// `type`: "sensor_msgs/msg/JointState", with its schema; both are added with their first message. `time`: ns.
  void add(const std::string& topic, std::string_view type, std::string_view schema, std::uint64_t time,
           std::span<const std::byte> cdr);
  /// Completes the chunk and writes it.
  void end_chunk();
  /// Writes the chunk and the index. Returns the errno of the first failed write; 0: the file is complete.
  int close();
  /// As close() returns it, so far.
  int failure() const noexcept;

 private:
  class DescriptorSink;
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace mrroc::recording
