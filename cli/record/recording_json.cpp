#include "cli/record/recording_json.hpp"

#include <stdexcept>

#include "messages/cdr_reader.hpp"
#include "messages/json_text.hpp"
#include "messages/message_table.hpp"
#include "recording/recording_reader.hpp"

namespace mrroc::cli::record {

namespace {

constexpr double kSecond = 1e9;  // ns

[[noreturn]] void refuse(const std::filesystem::path& file, const recording::RecordedMessage& message,
                         const std::string& why) {
  throw std::runtime_error(file.string() + ": message at " + std::to_string(message.time) + " ns of " + message.topic +
                           ": " + why);
}

const messages::MessageType& type_of(const std::filesystem::path& file, const recording::RecordedMessage& message) {
  for (const messages::MessageType& type : messages::message_types())
    if (type.name == message.type) return type;
  refuse(file, message, "type '" + message.type + "', expected one that this version records");
}

}  // namespace

bool print_json(const std::filesystem::path& file, const std::function<void(std::string_view line)>& write,
                const std::function<bool(const std::string& topic)>& wanted) {
  recording::RecordingReader reader(file);
  while (const std::optional<recording::RecordedMessage> message = reader.next()) {
    if (wanted && !wanted(message->topic)) continue;
    std::string line = "{\"time\":";
    messages::append_json(line, static_cast<double>(message->time) / kSecond);
    line += ",\"topic\":";
    messages::append_json(line, message->topic);
    line += ",\"type\":";
    messages::append_json(line, message->type);
    try {
      line += ",\"message\":" + type_of(file, *message).json(message->cdr) + "}";
    } catch (const messages::CdrError& error) {
      refuse(file, *message, error.what());
    }
    write(line);
  }
  return reader.complete();
}

}  // namespace mrroc::cli::record
