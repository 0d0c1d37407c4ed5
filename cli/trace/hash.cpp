#include "cli/trace/hash.hpp"

#include <stdexcept>
#include <string_view>

#include "cli/trace/reader.hpp"
#include "core/number_text.hpp"
#include "messages/mrroc_msgs/process_end.hpp"
#include "messages/mrroc_msgs/step.hpp"
#include "mrroc/fnv.hpp"
#include "recording/recording_reader.hpp"

namespace mrroc::cli::trace {

namespace {

std::string_view characters(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Hash hash_of(const std::filesystem::path& file) {
  recording::RecordingReader reader(file);
  Fnv1a hash;
  bool empty = true;
  while (const auto message = reader.next()) {
    if (message->type == messages::mrroc_msgs::Step::kType) {
      empty = false;
      hash.add(std::uint64_t{message->cdr.size()}).add(characters(message->cdr));
    } else if (message->type == messages::mrroc_msgs::ProcessEnd::kType) {
      empty = false;
      try {
        const auto end = messages::from_cdr<messages::mrroc_msgs::ProcessEnd>(message->cdr);
        hash.add(end.process).add(end.steps).add(end.dropped).add(end.cut);
      } catch (const messages::CdrError& error) {
        throw std::runtime_error(file.string() + ": " + message->topic + ": " + error.what());
      }
    }
  }
  if (empty) throw NoSteps(file);
  return {core::hexadecimal(hash.value()), reader.complete()};
}

}  // namespace mrroc::cli::trace
