#include "recording/chunked_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <mcap/writer.hpp>

namespace mrroc::recording {

namespace {

constexpr uint64_t kLargestChunk = 4'000'000;  // bytes before compression

}  // namespace

/// The bytes of a file, without a buffer: the writer hands over whole chunks.
class ChunkedFile::DescriptorSink final : public mcap::IWritable {
 public:
  explicit DescriptorSink(int fd) : fd_(fd) {}
  int failure() const noexcept { return failure_; }

  void handleWrite(const std::byte* data, uint64_t size) override {
    size_ += size;
    while (failure_ == 0 && size > 0) {
      const ssize_t written = ::write(fd_, data, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        failure_ = written < 0 ? errno : EIO;
        return;
      }
      data += written;
      size -= static_cast<uint64_t>(written);
    }
  }
  void end() override {}
  uint64_t size() const override { return size_; }

 private:
  int fd_;
  int failure_ = 0;
  uint64_t size_ = 0;
};

struct ChunkedFile::Writer {
  explicit Writer(int fd) : sink(fd) {}
  mcap::ChannelId channel_of(const std::string& topic, std::string_view type, std::string_view schema);

  DescriptorSink sink;
  mcap::McapWriter mcap;
  std::map<std::string, mcap::SchemaId, std::less<>> schemas;    // by type
  std::map<std::string, mcap::ChannelId, std::less<>> channels;  // by topic
  std::map<mcap::ChannelId, std::uint32_t> sequences;
};

mcap::ChannelId ChunkedFile::Writer::channel_of(const std::string& topic, std::string_view type,
                                                std::string_view schema) {
  if (const auto known = channels.find(topic); known != channels.end()) return known->second;
  auto known = schemas.find(type);
  if (known == schemas.end()) {
    mcap::Schema added(type, "ros2msg", schema);
    mcap.addSchema(added);
    known = schemas.emplace(type, added.id).first;
  }
  mcap::Channel channel(topic, "cdr", known->second);
  mcap.addChannel(channel);
  return channels.emplace(topic, channel.id).first->second;
}

ChunkedFile::ChunkedFile(int fd) : writer_(std::make_unique<Writer>(fd)) {
  mcap::McapWriterOptions options("ros2");
  options.chunkSize = kLargestChunk;
  options.compression = mcap::Compression::Zstd;
  options.compressionLevel = mcap::CompressionLevel::Fastest;
  writer_->mcap.open(writer_->sink, options);
}

ChunkedFile::~ChunkedFile() { writer_->mcap.terminate(); }

void ChunkedFile::add_metadata(const std::string& name, const std::map<std::string, std::string>& values) {
  mcap::Metadata metadata;
  metadata.name = name;
  metadata.metadata = {values.begin(), values.end()};
  (void)writer_->mcap.write(metadata);
}

void ChunkedFile::add_attachment(const std::string& name, const std::string& media_type, std::string_view content) {
  mcap::Attachment attachment{};
  attachment.name = name;
  attachment.mediaType = media_type;
  attachment.dataSize = content.size();
  attachment.data = std::as_bytes(std::span(content)).data();
  (void)writer_->mcap.write(attachment);
}

void ChunkedFile::add(const std::string& topic, std::string_view type, std::string_view schema, std::uint64_t time,
                      std::span<const std::byte> cdr) {
  if (failure() != 0) return;
  mcap::Message message;
  message.channelId = writer_->channel_of(topic, type, schema);
  message.sequence = writer_->sequences[message.channelId]++;
  message.logTime = time;
  message.publishTime = time;
  message.data = cdr.data();
  message.dataSize = cdr.size();
  (void)writer_->mcap.write(message);
}

void ChunkedFile::end_chunk() {
  if (failure() == 0) writer_->mcap.closeLastChunk();
}

int ChunkedFile::close() {
  if (failure() == 0) writer_->mcap.close();
  return failure();
}

int ChunkedFile::failure() const noexcept { return writer_->sink.failure(); }

}  // namespace mrroc::recording
