// mrroc_ros2: shows a run to ROS 2 as a node.
#include <memory>
#include <string>

#include "cli/operator/socket/side_program.hpp"
#include "cli/ros2/bridge.hpp"
#include "command/print.hpp"
#include "config/network/ros2_entry.hpp"

namespace mrroc::cli {
namespace {

class BridgeProgram final : public SideProgram {
 public:
  const char* description() const override {
    return "Shows a run to ROS 2 as a node, as the table [ros2] of its deployment says.";
  }
  void serve(WatchedRun run, int stop) override {
    config::Ros2Entry entry = run.deployment.ros2.value_or(config::Ros2Entry{});
    entry.domain = config::ros2_domain(entry);
    Bridge bridge(entry, run);
    command::print("ros2: node " + bridge.node() + " in domain " + std::to_string(*entry.domain) + "\n");
    bridge.serve(stop);
  }
};

}  // namespace
}  // namespace mrroc::cli

int main(int argc, char** argv) {
  using namespace mrroc::cli;
  return side_main(argc, argv, [] { return std::unique_ptr<SideProgram>(std::make_unique<BridgeProgram>()); });
}
