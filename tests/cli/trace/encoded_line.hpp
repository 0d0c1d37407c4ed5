#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cli/trace/step_of_line.hpp"
#include "process/record/encoded_step.hpp"

namespace mrroc::cli::trace {

/// The step that is read as this line, as its process puts it into the memories that it shares with the runner.
inline process::EncodedStep encoded_line(const Line& line) {
  const std::vector<std::byte> bytes = messages::to_cdr(to_message(line, 2'000'000));
  process::EncodedStep step;
  step.clear();
  for (const std::byte byte : std::span(bytes).subspan(step.view().size())) step << std::to_integer<std::uint8_t>(byte);
  return step;
}

}  // namespace mrroc::cli::trace
