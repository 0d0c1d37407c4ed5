#include "recording/recording_reader.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <mcap/crc32.hpp>
#include <mcap/reader.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "recording/recording_writer.hpp"

namespace mrroc::recording {

namespace {

constexpr std::size_t kRecordHeader = 9;              // opcode, length
constexpr std::uint64_t kLargestRecord = 64'000'000;  // bytes; our own chunks have at most 4 MB and one message

static_assert(kBeginning.size() == sizeof(mcap::Magic));

bool begins_with_magic(std::ifstream& stream) {
  std::array<char, kBeginning.size()> found{};
  return stream.read(found.data(), found.size()) && std::string_view(found.data(), found.size()) == kBeginning;
}

std::uint64_t length_at(const std::byte* bytes) noexcept {
  std::uint64_t length = 0;
  std::memcpy(&length, bytes, sizeof(length));
  return length;
}

}  // namespace

struct RecordingReader::File {
  explicit File(const std::filesystem::path& file) : path(file), stream(file, std::ios::binary) {
    if (!stream) throw std::runtime_error("cannot read the recording " + path.string() + ": " + std::strerror(errno));
    std::error_code none;
    size = std::filesystem::file_size(path, none);
    if (none) throw std::runtime_error("cannot read the recording " + path.string() + ": " + none.message());
    if (!begins_with_magic(stream))
      throw std::runtime_error(path.string() + ": is not an MCAP file, expected a recording of `mrroc run --record`");
    position = sizeof(mcap::Magic);
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw std::runtime_error(path.string() + ": byte " + std::to_string(record_at) + ": " + problem);
  }
  void check(const mcap::Status& status) const {
    if (!status.ok()) fail(status.message);
  }
  bool read_record();
  void take(const mcap::Record& record);
  void open_chunk(const mcap::Record& record);
  void take_message(const mcap::Record& record);
  bool advance();

  std::filesystem::path path;
  std::ifstream stream;
  std::uint64_t size = 0;        // of the file
  std::uint64_t position = 0;    // of the next record
  std::uint64_t record_at = 0;   // position of the present one
  std::vector<std::byte> bytes;  // of the present record of the file
  std::vector<std::byte> chunk;  // its records
  std::size_t chunk_at = 0;
  std::map<mcap::SchemaId, std::string> types;
  std::map<mcap::ChannelId, std::pair<std::string, std::string>> channels;  // topic, type
  std::map<std::string, std::string> metadata;
  std::optional<RecordedMessage> message;
  bool ended = false;     // no record follows
  bool complete = false;  // the end was written
};

/// False at the end of the file, which may be within a record.
bool RecordingReader::File::read_record() {
  std::array<std::byte, kRecordHeader> header{};
  record_at = position;
  if (size - position < kRecordHeader) return false;
  stream.read(reinterpret_cast<char*>(header.data()), header.size());
  const std::uint64_t length = length_at(header.data() + 1);
  if (!stream || length > size - position - kRecordHeader) return false;
  if (length > kLargestRecord)
    fail("a record of " + std::to_string(length) + " bytes, expected at most " + std::to_string(kLargestRecord));
  bytes.resize(length);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(length));
  if (!stream) return false;
  position += kRecordHeader + length;
  take({static_cast<mcap::OpCode>(header[0]), length, bytes.data()});
  return true;
}

void RecordingReader::File::take(const mcap::Record& record) {
  if (record.opcode == mcap::OpCode::Schema) {
    mcap::Schema schema;
    check(mcap::McapReader::ParseSchema(record, &schema));
    types[schema.id] = schema.name;
  } else if (record.opcode == mcap::OpCode::Channel) {
    mcap::Channel channel;
    check(mcap::McapReader::ParseChannel(record, &channel));
    const auto type = types.find(channel.schemaId);
    if (type == types.end())
      fail("channel " + channel.topic + " has schema " + std::to_string(channel.schemaId) + ", expected one before it");
    channels[channel.id] = {channel.topic, type->second};
  } else if (record.opcode == mcap::OpCode::Message) {
    take_message(record);
  } else if (record.opcode == mcap::OpCode::Chunk) {
    open_chunk(record);
  } else if (record.opcode == mcap::OpCode::Metadata) {
    mcap::Metadata found;
    check(mcap::McapReader::ParseMetadata(record, &found));
    if (found.name == kMetadata) metadata = {found.metadata.begin(), found.metadata.end()};
  } else if (record.opcode == mcap::OpCode::DataEnd) {
    ended = complete = true;
  }
}

void RecordingReader::File::take_message(const mcap::Record& record) {
  mcap::Message found;
  check(mcap::McapReader::ParseMessage(record, &found));
  const auto channel = channels.find(found.channelId);
  if (channel == channels.end())
    fail("a message of channel " + std::to_string(found.channelId) + ", expected a channel before it");
  message.emplace();
  message->topic = channel->second.first;
  message->type = channel->second.second;
  message->time = found.logTime;
  message->cdr.assign(found.data, found.data + found.dataSize);
}

void RecordingReader::File::open_chunk(const mcap::Record& record) {
  mcap::Chunk found;
  check(mcap::McapReader::ParseChunk(record, &found));
  if (found.uncompressedSize > kLargestRecord)
    fail("a chunk of " + std::to_string(found.uncompressedSize) + " bytes, expected at most " +
         std::to_string(kLargestRecord));
  if (found.compression == "zstd") {
    // the size in the compressed data itself, which is what it decompresses to, must agree before memory is taken
    const unsigned long long inner = ZSTD_getFrameContentSize(found.records, found.compressedSize);
    if (inner != found.uncompressedSize)
      fail("a chunk of " + std::to_string(found.uncompressedSize) + " bytes, expected the size of its zstd frame");
    chunk.resize(found.uncompressedSize);
    const std::size_t made = ZSTD_decompress(chunk.data(), chunk.size(), found.records, found.compressedSize);
    if (ZSTD_isError(made) != 0 || made != chunk.size()) fail("a chunk that zstd cannot decompress");
  } else if (found.compression.empty()) {
    chunk.assign(found.records, found.records + found.compressedSize);
  } else {
    fail("a chunk compressed with '" + found.compression + "', expected zstd or no compression");
  }
  using namespace mcap::internal;
  if (found.uncompressedCrc != 0 &&
      crc32Final(crc32Update(CRC32_INIT, chunk.data(), chunk.size())) != found.uncompressedCrc)
    fail("a chunk whose checksum is wrong");
  chunk_at = 0;
}

/// Takes one record more; false at the end.
bool RecordingReader::File::advance() {
  if (chunk_at == chunk.size()) {
    chunk.clear();
    chunk_at = 0;
    if (ended) return false;
    if (!read_record()) ended = true;
    return !ended;
  }
  const std::size_t left = chunk.size() - chunk_at;
  const std::uint64_t length = left < kRecordHeader ? 0 : length_at(chunk.data() + chunk_at + 1);
  if (left < kRecordHeader || length > left - kRecordHeader) fail("a chunk that ends within a record");
  const auto opcode = static_cast<mcap::OpCode>(chunk[chunk_at]);
  if (opcode == mcap::OpCode::Chunk) fail("a chunk within a chunk");
  const mcap::Record record{opcode, length, chunk.data() + chunk_at + kRecordHeader};
  chunk_at += kRecordHeader + length;
  take(record);
  return true;
}

bool is_recording(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return begins_with_magic(stream);
}

RecordingReader::RecordingReader(const std::filesystem::path& file) : file_(std::make_unique<File>(file)) {
  while (file_->metadata.empty() && !file_->message && file_->advance()) {
  }
  if (file_->metadata.empty())
    throw std::runtime_error(file.string() + ": is not a recording of a run, expected metadata '" + kMetadata + "'");
}

RecordingReader::~RecordingReader() = default;

const std::map<std::string, std::string>& RecordingReader::metadata() const noexcept { return file_->metadata; }

std::optional<RecordedMessage> RecordingReader::next() {
  file_->message.reset();
  while (!file_->message && file_->advance()) {
  }
  return std::move(file_->message);
}

bool RecordingReader::complete() const noexcept { return file_->complete; }

}  // namespace mrroc::recording
