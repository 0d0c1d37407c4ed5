#pragma once

#include <array>
#include <cstdint>

#include "mrroc/fixed_text.hpp"
#include "mrroc/types.hpp"

namespace mrroc::links {

/// The kind of the expected answer.
enum class QuestionKind : std::uint8_t {
  none = 0,    ///< no answer: it is a message
  number = 1,  ///< from `minimum` to `maximum`
  yes_no = 2,  ///< 1 or 0
  choice = 3   ///< the index of one of `choices`
};

/// A question or a message from a VSP or a task program to the operator.
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
  /// Number of the question; 0: the open question at its arrival, for scripts that answer without reading the question.
  std::uint64_t question = 0;
  double value = 0;
};

}  // namespace mrroc::links
