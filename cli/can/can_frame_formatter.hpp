#pragma once

#include <map>
#include <optional>
#include <string>

#include "can/frame.hpp"
#include "cli/can/io_frame_text.hpp"
#include "config/drives/drive_table.hpp"
#include "config/drives/io_table.hpp"
#include "drivers/socketcan/drive_setup.hpp"

namespace mrroc::cli {

/// Formats frames of a CANopen network as text. With a table of drives, nodes are named by axis and PDOs are decoded as
/// the robot's EDP maps them: states, rad of the shaft (as the drive counts) and A; objects have their names from the
/// EDS file. It remembers each drive's mode, which is needed to decode a statusword. With a table of I/O nodes, their
/// PDOs are decoded as the robot's inputs and outputs. One thread.
class CanFrameFormatter {
 public:
  CanFrameFormatter() = default;
  explicit CanFrameFormatter(config::DriveTable table);
  /// Adds the nodes of a table of I/O nodes.
  void add(const config::IoTable& io);

  /// One line, for any frame. Throws nothing but std::bad_alloc.
  std::string line(const can::Frame& frame);
  /// The kind of frames with this identifier: "shoulder TPDO 1", "SYNC"; empty outside the predefined connection set.
  std::string kind(std::uint32_t id) const;

 private:
  struct Named {
    config::DriveEntry entry;
    canopen::DriveMode mode;
  };
  std::string whose(unsigned node) const;
  std::optional<std::string> process_data(const can::Frame& frame, Named& drive) const;
  std::string command(const can::Frame& frame, Named& drive) const;

  std::optional<config::DriveTable> table_;
  edp::DrivePdos pdos_;
  std::map<unsigned, Named> drives_;    ///< by node
  std::map<unsigned, IoFrameText> io_;  ///< by node
};

}  // namespace mrroc::cli
