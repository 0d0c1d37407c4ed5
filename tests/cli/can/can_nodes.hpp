#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <string>
#include <thread>

#include "can/bus.hpp"
#include "canopen/identifiers.hpp"
#include "clock/wall/monotonic.hpp"
#include "config/robot_parameters_file.hpp"
#include "sim/can/drive_node.hpp"

namespace mrroc::cli {

inline RobotParameters irb6_parameters() {
  return config::read_robot_parameters(
      config::Table::load(std::filesystem::path(MRROC_SOURCE_DIR) / "robots/irb6/irb6.toml"));
}

inline config::DriveTable irb6_drives() {
  return config::read_drive_table(std::filesystem::path(MRROC_SOURCE_DIR) / "robots/irb6/irb6_drives.toml",
                                  irb6_parameters());
}

/// The IRb-6's simulated drives on a bus, with motors at rest; a thread serves them.
class CanNodes {
 public:
  explicit CanNodes(const std::string& bus) : bus_(can::open_bus(bus)) {
    const RobotParameters robot = irb6_parameters();
    const config::DriveTable table = irb6_drives();
    for (std::size_t i = 0; i < robot.axes.size(); ++i)
      nodes_.emplace_back(table, table.drives[i], robot.axes[i], 0.002,
                          [this](const can::Frame& frame) { bus_->send(frame); });
    thread_ = std::thread([this] { serve(); });
  }
  ~CanNodes() {
    stop_ = true;
    thread_.join();
  }
  CanNodes(const CanNodes&) = delete;
  CanNodes& operator=(const CanNodes&) = delete;

 private:
  void serve() {
    for (sim::DriveNode& node : nodes_) node.boot(clock::monotonic_ns());
    while (!stop_) {
      can::Frame frame;
      const bool came = bus_->receive(frame, clock::monotonic_ns() + 2'000'000);
      for (sim::DriveNode& node : nodes_) {
        if (came) node.take(frame, clock::monotonic_ns());
        node.update(clock::monotonic_ns());
      }
    }
  }

  std::unique_ptr<can::Bus> bus_;
  std::deque<sim::DriveNode> nodes_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace mrroc::cli
