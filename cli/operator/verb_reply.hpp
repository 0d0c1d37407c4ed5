#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mrroc/types.hpp"

namespace mrroc::cli {

/// Why a request was refused; the name is the member "reason" of the reply.
enum class Refusal {
  none,
  malformed,         ///< not a request: no JSON object, too long, a member of a wrong type
  unknown_verb,      ///< not in the table
  invalid_argument,  ///< an argument is missing, unknown, or its value is invalid
  not_allowed,       ///< not in the present state of the deployment
  not_commander,     ///< another client holds command
  ended,             ///< the deployment ended before the command took effect
  // ---- how a trajectory ended
  invalid_trajectory,  ///< nothing has moved for it
  path_tolerance,      ///< the robot was too far from it
  goal_tolerance,      ///< the robot rests too far from its end
  cancelled,           ///< by `cancel`, or replaced by another one
  taken_back           ///< the task no longer yields the robot
};

/// "malformed", "unknown_verb", ... Any thread.
const char* name_of(Refusal refusal) noexcept;

/// The answer to a request: what happened, or why nothing did.
struct VerbReply {
  Refusal refusal = Refusal::none;
  std::string text;          ///< one sentence: what happened, or what is wrong
  std::string expected;      ///< of a refusal: what would be accepted; may be empty
  std::optional<Tick> tick;  ///< at which the command took effect
  std::string data;          ///< JSON of verbs that report something; empty: none
  std::optional<std::int64_t> id;

  bool ok() const noexcept { return refusal == Refusal::none; }
};

/// A reply that says what happened. Any thread.
VerbReply done(std::string text);
/// A reply that refuses a request. Any thread.
VerbReply refuse(Refusal refusal, std::string text, std::string expected = "");
/// `refuse` for a request that another state of the deployment would allow.
VerbReply not_now(std::string text, std::string expected);

/// One line of JSON without its end: {"id", "ok", "tick", "text", "data"} or {"id", "ok", "reason", "text",
/// "expected"}; bytes that are not UTF-8 are replaced. Any thread.
std::string to_json(const VerbReply& reply);
/// The reply of such a line; null for another line: a greeting, an event. Any thread; does not throw.
std::optional<VerbReply> parse_reply(const std::string& json);
/// The text for people: "text" or "text, expected ...". Any thread.
std::string to_text(const VerbReply& reply);

}  // namespace mrroc::cli
