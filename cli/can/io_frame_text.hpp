#pragma once

#include <optional>
#include <string>

#include "can/frame.hpp"
#include "config/drives/io_table.hpp"
#include "drivers/socketcan/io_pdos.hpp"

namespace mrroc::cli {

/// Formats the PDOs of one CiA 401 node as text, as its EDP maps them. Terminals have the robot's numbers, analogue
/// values the table's unit. Any thread, constant.
class IoFrameText {
 public:
  explicit IoFrameText(const config::IoEntry& entry);

  /// "I/O node 40".
  std::string name() const { return "I/O node " + std::to_string(entry_.node); }
  const canopen::EdsFile& eds() const noexcept { return entry_.eds; }
  /// "TPDO 1: digital inputs 0 to 7, on: 0, 3"; nothing when the frame is too short or is not one of its PDOs.
  std::optional<std::string> process_data(const can::Frame& frame) const;

 private:
  config::IoEntry entry_;
  edp::IoPdos pdos_;
};

}  // namespace mrroc::cli
