#pragma once

#include <array>
#include <cstdint>

#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::links {

/// What kind of answer is expected.
enum class QuestionKind : std::uint8_t {
  none = 0,    ///< none: it is a message
  number = 1,  ///< from `minimum` to `maximum`
  yes_no = 2,  ///< 1 or 0
  choice = 3   ///< the index of one of `choices`
};

/// From a VSP or a task program to the operator: what a task program wants to know, or wants him to know.
struct OperatorQuestion {
  static constexpr std::size_t kChoices = 8;

  FixedText<127> text;
  QuestionKind kind = QuestionKind::number;
  double minimum = 0;
  double maximum = 0;
  std::uint8_t choice_count = 0;
  std::array<FixedText<31>, kChoices> choices;
  Tick tick = 0;  ///< at which it was asked
};

/// The operator's answer.
struct OperatorAnswer {
  /// Number of the question; 0: whichever is open when it arrives, for one who answers by a script and sees none.
  std::uint64_t question = 0;
  double value = 0;
};

}  // namespace mrroc::links
