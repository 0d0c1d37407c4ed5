#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mrroc/condition.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// The reason why an instruction ended without an error.
enum class Ending : std::uint8_t {
  condition,  ///< a condition given to `Wait`, or to the generator with `until`, held
  generator,  ///< the generator's own terminal condition held
  end_motion  ///< the operator or the superior process asked for the next instruction
};

/// The result of `Move` and `Wait`.
struct Outcome {
  Ending ending = Ending::condition;
  /// Steps executed: commands sent to each robot. 0 when the condition held at i0.
  std::uint64_t steps = 0;
  /// First and last tick of the received states.
  Tick start_tick = 0;
  Tick end_tick = 0;
  /// Worst skew of the robots: ticks between the first and the last start of a common macrostep.
  Tick skew = 0;
  double duration = 0;       ///< s, from the ticks
  double wall_duration = 0;  ///< s, measured
  /// The whole condition that held, for its lifetime; null unless `ending` is `condition`.
  std::shared_ptr<const Condition> condition;
  /// The parts whose value made it hold.
  std::vector<const Condition*> reasons;

  /// Whether a condition of class C was (one of) the reason(s): `if (end.by<Travelled>()) ...`.
  template <class C>
  bool by() const noexcept {
    for (const Condition* reason : reasons) {
      if (dynamic_cast<const C*>(reason) != nullptr) return true;
    }
    return false;
  }
  /// Whether the condition of this name was (one of) the reason(s).
  bool by(std::string_view name) const noexcept;
  /// For an instruction that is to end by one condition only: throws NonFatalError(task_failed) with `otherwise` unless
  /// by<C>(). `Move(...).require<Gripped>("no part between the fingers");`
  template <class C>
  const Outcome& require(std::string_view otherwise) const {
    if (!by<C>()) fail(otherwise);
    return *this;
  }
  /// The same with the condition of this name.
  const Outcome& require(std::string_view name, std::string_view otherwise) const;
  /// Names of the reasons joined with " and "; "generator" or "end of motion" when it was not a condition.
  std::string reason() const;

 private:
  [[noreturn]] static void fail(std::string_view otherwise);
};

}  // namespace mrroc
