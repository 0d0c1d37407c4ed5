#include "can/bus.hpp"
#include "clock/wall/wait.hpp"
#include "config/drives/drive_table.hpp"
#include "drivers/socketcan/can_hardware.hpp"
#include "edp/driver.hpp"
#include "mrroc/errors.hpp"

namespace {

using namespace mrroc;

constexpr std::int64_t kBusTimeout = 60 * clock::kSecond, kBetweenAttempts = clock::kSecond / 50;

/// The simulated drives may not have made the hub's socket yet.
std::unique_ptr<can::Bus> open_bus(const std::string& name) {
  const std::int64_t end = clock::monotonic_ns() + kBusTimeout;
  for (;;) {
    try {
      return can::open_bus(name);
    } catch (const std::runtime_error& error) {
      if (!name.starts_with("unix:") || clock::monotonic_ns() > end)
        throw HardwareError(ErrorCode::hardware_silent, error.what());
      clock::pause(kBetweenAttempts);
    }
  }
}

std::unique_ptr<edp::Hardware> make(const edp::DriverContext& context) {
  using edp::CanHardware;
  const config::CanEntry& can = *context.robot.can;
  const RobotParameters& parameters = context.model.parameters();
  config::DriveTable table = config::read_drive_table(can.drives, parameters);
  config::IoTable io;
  if (!can.io.empty()) io = config::read_io_table(can.io, table);
  const auto timing = context.simulated_time ? CanHardware::Timing{CanHardware::kFenceTimeout, false, true}
                                             : CanHardware::Timing{table.answer_time * context.servo_period, true};
  return std::make_unique<CanHardware>(
      std::move(table), parameters, context.servo_period, [name = can.interface] { return open_bus(name); }, timing,
      context.robot.synchronised, io);
}

}  // namespace

MRROC_DRIVER(make)
