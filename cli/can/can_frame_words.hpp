#pragma once

#include <map>
#include <optional>
#include <string>

#include "can/frame.hpp"
#include "config/drives/drive_table.hpp"
#include "edp/drivers/can/drive_setup.hpp"

namespace mrroc::cli {

/// Frames of a CANopen network in words; with a table of drives, by the drives' axes: what PDOs carry, as the EDP of
/// the robot maps them, in states, rad of the shaft (as the drive counts) and A; objects with their names of the EDS
/// file. It remembers each drive's mode, by which a statusword is read. One thread.
class FrameWords {
 public:
  FrameWords() = default;
  explicit FrameWords(config::DriveTable table);

  /// One line. Any frame whatsoever; never throws but for want of memory.
  std::string line(const can::Frame& frame);
  /// What frames with this identifier are: "shoulder TPDO 1", "SYNC"; empty: nothing of the predefined connection set.
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
  std::map<unsigned, Named> drives_;  ///< by node
};

}  // namespace mrroc::cli
