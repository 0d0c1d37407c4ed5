#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "mrroc/robot_command.hpp"
#include "mrroc/step_record.hpp"

namespace mrroc::process {

/// Words of a trace for the values of an enumeration.
template <class Value, std::size_t N>
using TraceWords = std::array<std::pair<std::string_view, Value>, N>;

/// Every change of the robot itself is a "change": it is commanded by neither Move nor Wait.
inline constexpr TraceWords<CommandKind, 9> kCommandWords{{{"query", CommandKind::query},
                                                           {"hold", CommandKind::hold},
                                                           {"joint", CommandKind::joint},
                                                           {"pose", CommandKind::pose},
                                                           {"motor", CommandKind::motor},
                                                           {"joint_velocity", CommandKind::joint_velocity},
                                                           {"twist", CommandKind::twist},
                                                           {"force", CommandKind::force},
                                                           {"change", CommandKind::set_tool}}};

inline constexpr TraceWords<StepEnding, 7> kEndingWords{{{"condition", StepEnding::condition},
                                                         {"generator", StepEnding::generator},
                                                         {"end_motion", StepEnding::end_motion},
                                                         {"stopped", StepEnding::stopped},
                                                         {"non_fatal_error", StepEnding::non_fatal_error},
                                                         {"hardware_error", StepEnding::hardware_error},
                                                         {"system_error", StepEnding::system_error}}};

/// The word of `value`; the last one for a value without a word.
template <class Value, std::size_t N>
constexpr std::string_view word_of(const TraceWords<Value, N>& words, Value value) noexcept {
  for (const auto& [word, known] : words)
    if (known == value) return word;
  return words.back().first;
}

}  // namespace mrroc::process
