#pragma once

#include <functional>
#include <memory>

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

using SensorFactory = std::function<std::unique_ptr<VirtualSensor>()>;

/// main() of a VSP: the process of one virtual sensor. It opens the source that the deployment names, passes the
/// start-up barrier, and from then on answers requests and publishes readings (`Sampler`), under every clock in the
/// same way.
int run(int argc, char** argv, const SensorFactory& factory);

}  // namespace mrroc::vsp

/// Makes a VSP out of a class derived from VirtualSensor.
#define MRROC_VSP(SensorClass)                                                          \
  int main(int argc, char** argv) {                                                     \
    return mrroc::vsp::run(argc, argv, [] { return std::make_unique<SensorClass>(); }); \
  }
