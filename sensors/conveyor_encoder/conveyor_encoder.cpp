#include "mrroc/sensors/conveyor_encoder.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

std::string condition_name(const ConveyorEncoder& encoder, double metres) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " travelled %g m", metres);
  return encoder.name() + text.data();
}

}  // namespace

ConveyorEncoder::ConveyorEncoder(Task& task, const std::string& name) : Sensor(task, name, "conveyor_encoder") {}

BeltTravelled::BeltTravelled(const ConveyorEncoder& encoder, double metres)
    : Condition(condition_name(encoder, metres)), encoder_(&encoder), metres_(metres) {
  if (!(metres > 0) || !std::isfinite(metres)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "BeltTravelled " + std::to_string(metres) + " m, expected a finite distance above 0");
  }
}

bool BeltTravelled::holds() { return std::abs(encoder_->position() - origin_) >= metres_; }

}  // namespace mrroc
