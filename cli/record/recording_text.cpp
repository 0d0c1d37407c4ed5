#include "cli/record/recording_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <map>
#include <stdexcept>
#include <vector>

#include "cli/output/trace.hpp"
#include "cli/record/recording_reader.hpp"
#include "cli/record/step_message.hpp"
#include "cli/trace/fields.hpp"
#include "cli/trace/format_line.hpp"
#include "messages/json_text.hpp"
#include "messages/message_table.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "process/record/trace_header.hpp"

namespace mrroc::cli::record {

namespace {

using messages::mrroc_msgs::ProcessEnd;
using messages::mrroc_msgs::Step;

constexpr double kSecond = 1e9;  // ns

std::string text_of(const ProcessEnd& end) {
  trace::Remark remark;
  remark.process = end.process;
  remark.lines = end.steps;
  remark.dropped = end.dropped;
  remark.cut = end.cut;
  return trace::format_remark(remark);
}

[[noreturn]] void refuse(const std::filesystem::path& file, const RecordedMessage& message, const std::string& why) {
  throw std::runtime_error(file.string() + ": message at " + std::to_string(message.time) + " ns of " + message.topic +
                           ": " + why);
}

const messages::MessageType& type_of(const std::filesystem::path& file, const RecordedMessage& message) {
  for (const messages::MessageType& type : messages::message_types())
    if (type.name == message.type) return type;
  refuse(file, message, "type '" + message.type + "', expected one that this version records");
}

}  // namespace

TraceOfRecording trace_of(const std::filesystem::path& file) {
  RecordingReader reader(file);
  const bool last = reader.metadata().contains("last");   // the last seconds: it begins anywhere, as a black box does
  std::map<std::string, std::vector<std::string>> lines;  // by process
  while (const std::optional<RecordedMessage> message = reader.next()) try {
      if (message->type == Step::kType) {
        const auto step = messages::from_cdr<Step>(message->cdr);
        lines[step.process].push_back(trace::format_line(to_line(step)));
      } else if (message->type == ProcessEnd::kType) {
        auto end = messages::from_cdr<ProcessEnd>(message->cdr);
        if (last) end.steps = lines[end.process].size();
        lines[end.process].push_back(text_of(end));
      }
    } catch (const messages::CdrError& error) {
      refuse(file, *message, error.what());
    } catch (const trace::Malformed& error) {
      refuse(file, *message, error.what());
    }
  std::map<std::string, std::vector<std::string_view>> views;
  for (const auto& [process, own] : lines) views[process] = {own.begin(), own.end()};
  const auto clock = reader.metadata().find("clock");
  const std::string name = clock == reader.metadata().end() ? "" : clock->second;
  const std::string_view mark = last ? process::kBlackBoxMark : "";
  return {fmt::format("{}{}{}\n{}", process::kTraceHeader, name, mark, merge_lines(views)), reader.complete()};
}

bool print_json(const std::filesystem::path& file, const std::function<void(std::string_view line)>& write,
                const std::function<bool(const std::string& topic)>& wanted) {
  RecordingReader reader(file);
  while (const std::optional<RecordedMessage> message = reader.next()) {
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
