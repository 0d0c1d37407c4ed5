#pragma once

#include <string_view>

#include "config/deployment.hpp"
#include "mrroc/step_record.hpp"
#include "process/record/encoded_step.hpp"

namespace mrroc::process {

/// Encodes one step of `process` as mrroc_msgs/msg/Step (src/messages/msg). A step that is longer than the buffer is
/// marked `cut`: without robots, sensors, conditions and ending. Neither allocates nor throws.
void encode_step(EncodedStep& step, const config::Deployment& deployment, std::string_view process,
                 const StepRecord& record) noexcept;

}  // namespace mrroc::process
