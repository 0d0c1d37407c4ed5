#pragma once

#include <span>
#include <string>
#include <string_view>

namespace mrroc::cli {

/// One argument of a verb: a member of the socket's request, a word of a typed line, a positional of the command line.
struct VerbArgument {
  std::string_view name;
  std::string_view summary;
  bool required = true;
  bool file = false;  ///< a path; a relative one is in the working folder of the client, at the socket of the run
};

/// A verb of the operator. The typed lines of a run, the commands `mrroc VERB`, the manual page, the completion and the
/// page of the socket's protocol are made from the table of them.
struct OperatorVerb {
  std::string_view name;
  std::string_view summary;
  std::string_view effect;  ///< one sentence for the reply when it has taken effect
  std::span<const VerbArgument> arguments;
  bool commands = false;  ///< only the commander may use it, and it is refused while another client holds command
  bool lasts = false;     ///< the reply comes when the robot has finished
};

/// All verbs, in the order of their description. Any thread.
std::span<const OperatorVerb> operator_verbs() noexcept;
/// The verb of this name; null when it is unknown. Any thread.
const OperatorVerb* find_verb(std::string_view name) noexcept;
/// The name of the verb that is most similar to `name`, within two edits; empty when none is. Any thread.
std::string nearest_verb(std::string_view name);
/// "answer VALUE [FROM]": the verb with its arguments. Any thread.
std::string usage_of(const OperatorVerb& verb);

}  // namespace mrroc::cli
