#pragma once

#include <memory>
#include <optional>

#include "driver_faults/device.hpp"
#include "drivers/netft/netft_source.hpp"
#include "drivers/ur/controller.hpp"
#include "links/test_clock.hpp"
#include "sim/netft/netft_server.hpp"

namespace mrroc::driver_faults {

/// An arm behind a simulated UR controller, with a simulated Net F/T at its flange, both over loopback, on the wall
/// clock.
class UrDevice final : public Device {
 public:
  UrDevice();
  ~UrDevice() override;

  const RobotModel& model() const override { return model_; }
  edp::Hardware& hardware() override { return *hardware_; }
  edp::ForceSensor* wrist() override;
  edp::RobotTicker::Place wait_next() override { return ticker_->wait_next(); }
  double speed(const edp::Snapshot& seen) override;

  ur::Controller controller;
  sim::NetftServer sensor;

 private:
  class Wrist;

  ur::SixJoints model_;
  links::TestClock clock_;
  std::unique_ptr<ur::UrHardware> hardware_;
  std::unique_ptr<Wrist> wrist_;
  std::optional<edp::RobotTicker> ticker_;
};

}  // namespace mrroc::driver_faults
