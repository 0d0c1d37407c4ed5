#pragma once

#include <cstdint>

#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::links {

/// From a VSP to the operator: what a task program wants to know.
struct OperatorQuestion {
  FixedText<127> text;
  Tick tick = 0;  ///< at which it was asked
};

/// The operator's answer to a VSP.
struct OperatorAnswer {
  /// Number of the question; 0: whichever is open when it arrives, for one who answers by a script and sees none.
  std::uint64_t question = 0;
  double value = 0;
};

}  // namespace mrroc::links
