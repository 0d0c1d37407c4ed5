#pragma once

#include <array>

#include "canopen/identifiers.hpp"
#include "canopen/pdo_mapping.hpp"
#include "config/drives/io_table.hpp"
#include "mrroc/signals.hpp"

namespace mrroc::edp {

/// The PDOs of one CiA 401 node, as the profile maps them by default: PDO 1 has the digital terminals in blocks of 8,
/// PDO 2 the analogue ones 1 to 4, PDO 3 those 5 to 8; a PDO without terminals is not used. An analogue value is 16
/// bits, 32767 the end of the terminals' range.
///
/// Allocates in the constructor only; never throws. Any thread, constant.
class IoPdos {
 public:
  static constexpr int kCount = 3;  ///< in each direction

  explicit IoPdos(const config::IoEntry& entry);

  /// The mapping of TPDO or RPDO `number`, 1 to kCount; empty: not used.
  const canopen::PdoMapping& transmit(int number) const noexcept { return transmit_[index(number)]; }
  const canopen::PdoMapping& receive(int number) const noexcept { return receive_[index(number)]; }

  /// Writes the inputs of TPDO `number` into the node's terminals of `inputs`. False: the frame is too short, nothing
  /// is written.
  bool read(const can::Frame& frame, int number, ControllerIo& inputs) const noexcept;
  /// The same with the outputs of RPDO `number`, for a listener on the bus.
  bool read_outputs(const can::Frame& frame, int number, ControllerIo& outputs) const noexcept;
  /// The data of RPDO `number` for the node's terminals of `outputs`; analogue values beyond the range become its end.
  can::Frame write(int number, const ControllerIo& outputs) const noexcept;
  /// Copies the values of the node's inputs.
  void copy_inputs(const ControllerIo& from, ControllerIo& to) const noexcept;

 private:
  static std::size_t index(int number) noexcept { return static_cast<std::size_t>(number - 1); }

  canopen::NodeId node_;
  config::TerminalRange digital_inputs_, digital_outputs_;
  config::AnalogTerminals analog_inputs_, analog_outputs_;
  std::array<canopen::PdoMapping, kCount> transmit_, receive_;
};

}  // namespace mrroc::edp
