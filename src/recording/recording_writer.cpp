#include "recording/recording_writer.hpp"

#include <utility>

#include "command/version.hpp"
#include "config/clock_names.hpp"
#include "config/text/message_text.hpp"
#include "messages/mrroc_msgs/step.hpp"

namespace mrroc::recording {

namespace {

constexpr std::uint64_t kChunk = 1'000'000'000;  // ns

}  // namespace

std::map<std::string, std::string> metadata_of(const config::Deployment& deployment) {
  return {{"version", std::string{command::version()}},
          {"deployment", deployment.name},
          {"clock", config::name_of(deployment.clock)},
          {"servo_period", config::number_text(deployment.servo_period)}};
}

RecordingWriter::RecordingWriter(int fd, const config::Deployment& deployment, const std::string& text,
                                 const std::optional<double>& last)
    : period_(nanoseconds_of(deployment.servo_period)), metadata_(metadata_of(deployment)), text_(text) {
  if (last) {
    metadata_.emplace(kLast, config::number_text(*last));
    recent_.emplace(nanoseconds_of(*last));
  } else {
    begin(file_.emplace(fd));
  }
}

RecordingWriter::RecordingWriter(int fd, double servo_period, Metadata metadata, const std::string& text)
    : period_(nanoseconds_of(servo_period)), metadata_(std::move(metadata)), text_(text) {
  begin(file_.emplace(fd));
}

void RecordingWriter::begin(ChunkedFile& file) const {
  file.add_metadata(kMetadata, metadata_);
  file.add_attachment(kDeployment, "application/toml", text_);
}

void RecordingWriter::write_step(const std::string& process, Tick tick, std::vector<std::byte> cdr) {
  using messages::mrroc_msgs::Step;
  write({"/" + process + kStepTopicEnd, Step::kType, Step::schema(), time_of(tick, period_), std::move(cdr)});
}

void RecordingWriter::write(RecentMessages::Message message) {
  if (file_) return add(*file_, second_, message);
  const std::lock_guard lock(mutex_);
  recent_->add(std::move(message));
}

void RecordingWriter::add(ChunkedFile& file, std::uint64_t& second, const RecentMessages::Message& message) {
  if (const std::uint64_t of_message = message.time / kChunk; of_message > second) {
    second = of_message;
    file.end_chunk();
  }
  file.add(message.topic, message.type, message.schema, message.time, message.cdr);
}

bool RecordingWriter::empty() const {
  const std::lock_guard lock(mutex_);
  return recent_->messages().empty();
}

int RecordingWriter::save(int fd) const {
  ChunkedFile file(fd);
  begin(file);
  std::uint64_t second = 0;
  const std::lock_guard lock(mutex_);
  for (const RecentMessages::Message& message : recent_->messages()) add(file, second, message);
  return file.close();
}

}  // namespace mrroc::recording
