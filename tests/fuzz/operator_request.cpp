// Requests to the operator's socket and typed verbs of any content, keys of a terminal, and replies as a client reads
// them.
#include <algorithm>

#include "cli/operator/operator_state.hpp"
#include "cli/operator/terminal/line_editor.hpp"
#include "cli/operator/verb_reply.hpp"
#include "cli/operator/verb_request.hpp"
#include "fuzz/fuzz.hpp"

namespace {

using mrroc::cli::VerbReply;
using mrroc::cli::VerbRequest;

void check_request(const std::optional<VerbRequest>& request, const VerbReply& refusal) {
  if (request) {
    fuzz::require(request->verb != nullptr, "a request has a verb");
    for (const auto& argument : request->verb->arguments)
      fuzz::require(!argument.required || !request->argument(argument.name).empty(), "a required argument has a value");
    fuzz::require(request->arguments.size() <= request->verb->arguments.size(), "no argument is unknown");
    return;
  }
  fuzz::require(!refusal.ok() && !refusal.text.empty(), "a refusal has a reason");
  const std::string line = to_json(refusal);
  fuzz::require(line.find('\n') == std::string::npos, "a reply is one line");
  const auto read = mrroc::cli::parse_reply(line);
  fuzz::require(read && read->refusal == refusal.refusal, "a reply is read as it was sent");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes input(data, size);
  const std::string_view text = input.rest();
  VerbReply refusal;
  const auto typed = mrroc::cli::parse_typed(text, refusal);
  check_request(typed, refusal);
  refusal = {};
  const auto sent = mrroc::cli::parse_json(text, refusal);
  check_request(sent, refusal);
  mrroc::cli::parse_reply(std::string{text});
  mrroc::cli::event_text(std::string{text});
  mrroc::cli::LineEditor editor;
  const std::string lines = editor.feed(text);
  fuzz::require(std::none_of(lines.begin(), lines.end(),
                             [](char c) { return c != '\n' && static_cast<unsigned char>(c) < 0x20; }),
                "a typed line has no control character");
  return 0;
}
