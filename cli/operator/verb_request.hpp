#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "cli/operator/operator_verbs.hpp"
#include "cli/operator/verb_reply.hpp"

namespace mrroc::cli {

/// A request of a client: a verb of the table with its arguments. Every argument has a value that is not empty, every
/// required one is present, and no other is.
struct VerbRequest {
  const OperatorVerb* verb = nullptr;
  std::map<std::string, std::string, std::less<>> arguments;  ///< by name
  std::optional<std::int64_t> id;                             ///< chosen by the client; the reply repeats it

  /// The value of an argument; empty when it is not given.
  std::string_view argument(std::string_view name) const;
};

/// The request of a typed line: the verb, then its required arguments in the order of the table, separated by blanks;
/// the last one may contain blanks. Words "name=value" before and after them are optional arguments. Otherwise the
/// reply that refuses it. Any thread; does not throw.
std::optional<VerbRequest> parse_typed(std::string_view line, VerbReply& refusal);

/// The request of a line of the socket: a JSON object with "verb", the arguments as texts or numbers, and an optional
/// integer "id". Otherwise the reply that refuses it, with the id when it was understood. Any thread; does not throw.
std::optional<VerbRequest> parse_json(std::string_view line, VerbReply& refusal);

}  // namespace mrroc::cli
