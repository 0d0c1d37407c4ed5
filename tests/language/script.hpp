#pragma once

#include <optional>
#include <ostream>

#include "language/call_log.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/outcome.hpp"
#include "mrroc/task.hpp"

namespace mrroc::fakes {

inline constexpr std::uint64_t kNeverEnds = ~std::uint64_t{0};

struct RobotScript {
  int motion_steps = 10;
  int reply_step = 8;
  bool addressed = true;  ///< the generator writes its command
  bool moving = false;    ///< the command ends with a velocity
};

struct SensorScript {
  bool interactive = true;
  std::uint32_t period = 1;
  std::uint64_t ready_from = 0;  ///< non-interactive: number of its first available reading
};

/// A leaf is true at its k-th evaluation of an instruction when bit min(k, 63) of the pattern is set.
struct LeafScript {
  std::uint64_t pattern = 0;
  bool red = false;  ///< class Red, otherwise class Blue

  bool at(std::uint64_t k) const { return ((pattern >> std::min<std::uint64_t>(k, 63)) & 1) != 0; }
};

/// A node of the condition's tree. Children precede their parent, the root is the last node.
struct NodeScript {
  enum class Kind { leaf, both, either, negated };
  Kind kind = Kind::leaf;
  std::size_t a = 0;  ///< the leaf's number, or the node of the first part
  std::size_t b = 0;
  bool named = false;  ///< by `rename`: "node<number>"
};

/// The device reports an error at its `reception`-th reply (from 0, the one at i0).
struct FaultScript {
  bool of_robot = true;
  std::size_t device = 0;
  std::uint64_t reception = 0;
  ErrorClass error_class = ErrorClass::non_fatal;
  ErrorCode code = ErrorCode::busy;
};

/// One Move or Wait with everything that determines its behaviour.
struct Script {
  bool is_move = true;
  std::vector<RobotScript> robots;
  std::vector<SensorScript> sensors;
  std::vector<LeafScript> leaves;
  std::vector<NodeScript> nodes;              ///< empty: a Move without `until`
  std::uint64_t generator_ends = kNeverEnds;  ///< the step at which its terminal condition becomes true
  std::vector<FaultScript> faults;
  std::vector<OperatorRequest> requests;  ///< the last one ends the instruction
};

std::ostream& operator<<(std::ostream& out, const Script& script);

struct ThrownError {
  ErrorClass error_class;
  ErrorCode code;
  std::string process;
  std::string device;
  std::uint64_t step;
  Tick tick;
  friend bool operator==(const ThrownError&, const ThrownError&) = default;
};

struct Result {
  Ending ending;
  std::uint64_t steps;
  Tick start_tick;
  Tick end_tick;
  double duration;
  double wall_duration;
  std::vector<std::string> reasons;
  bool by_red;
  bool by_blue;
  friend bool operator==(const Result&, const Result&) = default;
};

/// Result of a script: all calls, and one of outcome, error, stop.
struct RunRecord {
  std::vector<Call> calls;
  std::optional<Result> result;
  std::optional<ThrownError> error;
  bool stopped = false;
  friend bool operator==(const RunRecord&, const RunRecord&) = default;
};

std::ostream& operator<<(std::ostream& out, const RunRecord& run);

/// Runs the script through the real Move or Wait, on fakes. Observed steps are calls of `observe`: tick, step (value)
/// and whether it is the last one (who = "last").
RunRecord execute(const Script& script);

/// The prediction of the paper's equations (3) and (5) for the script. Shares no code with the language.
RunRecord predict(const Script& script);

/// The value of the tree at the k-th evaluation, and the names of the parts that made it true; computed from the tree
/// alone.
bool predict_value(const Script& script, std::size_t node, std::uint64_t k);
std::string predict_name(const Script& script, std::size_t node);
void predict_reasons(const Script& script, std::size_t node, std::uint64_t k, Result& result);

/// The tree as conditions of the language; `log` may be null.
std::shared_ptr<Condition> build_condition(const Script& script, std::size_t node, CallLog* log);
class Red;
class Blue;
/// The outcome in the form of a prediction.
Result result_of(const Outcome& outcome);

}  // namespace mrroc::fakes
