#include "drivers/socketcan/io_fault.hpp"

#include "canopen/emergency.hpp"

namespace mrroc::edp {
namespace {

struct DescribeIo {
  unsigned node;

  DriverText operator()(std::monostate) const noexcept { return {}; }
  DriverText operator()(IoRestarted) const noexcept {
    return driver_text("node %u has restarted, or is not operational", node);
  }
  DriverText operator()(const IoSetupRefused& refused) const noexcept {
    const std::string_view reason = canopen::describe(refused.reason);
    return driver_text("node %u refuses to be set up: object %04Xh:%u, %.*s", node, refused.object.index,
                       refused.object.sub, static_cast<int>(reason.size()), reason.data());
  }
  DriverText operator()(const IoSilent& silent) const noexcept {
    return driver_text("node %u: no TPDO %d, inputs, after more than %d SYNCs in a row", node, silent.pdo,
                       silent.allowed);
  }
  DriverText operator()(const IoHeartbeatLost& lost) const noexcept {
    return driver_text("node %u: the last heartbeat is %llu ticks old, limit %llu", node,
                       static_cast<unsigned long long>(lost.age), static_cast<unsigned long long>(lost.allowed));
  }
  DriverText operator()(const IoError& error) const noexcept {
    const std::string_view text = canopen::error_text(error.code);
    return driver_text("node %u: error code %04Xh, %.*s", node, error.code, static_cast<int>(text.size()), text.data());
  }
};

}  // namespace

DriverText describe(canopen::NodeId node, const IoFault& fault) noexcept { return std::visit(DescribeIo{node}, fault); }

}  // namespace mrroc::edp
