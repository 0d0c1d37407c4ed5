#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "canopen/eds_file.hpp"
#include "canopen/identifiers.hpp"
#include "config/drives/drive_table.hpp"
#include "config/drives/node_objects.hpp"

namespace mrroc::config {

/// The framework's EDS file of an I/O node.
inline constexpr const char* kGeneralIoEds = "cia401.eds";

/// Terminals `first` to `first + count - 1` of a robot's controller (`ControllerIo`).
struct TerminalRange {
  int first = 0;
  int count = 0;
};

/// Analogue terminals: value `range` is 32767 counts of the node, in the terminals' own unit.
struct AnalogTerminals : TerminalRange {
  double range = 10.0;
};

/// One CiA 401 node.
struct IoEntry {
  canopen::NodeId node = 0;
  TerminalRange digital_inputs, digital_outputs;
  AnalogTerminals analog_inputs, analog_outputs;
  canopen::EdsFile eds;
  std::vector<NodeSetting> settings;  ///< of its table `objects`, in the order of the file
};

/// The I/O nodes of a robot on a CAN bus. Their terminals are numbered in the order of the file, each kind from 0.
/// docs/how-to/can.md explains every key.
struct IoTable {
  std::filesystem::path file;
  std::vector<IoEntry> nodes;

  /// Number of digital inputs of all nodes: terminals 0 to this number - 1 exist.
  int digital_inputs() const noexcept;
};

/// Reads a table of I/O nodes that share the bus with `drives`. Throws ConfigurationError: an error in it or in an EDS
/// file that it names; no node; a node number that a drive, the master or another node has; a node without terminals;
/// more terminals than ControllerIo has; an object that is not in the EDS file, is read-only or is written by the EDP
/// itself.
IoTable read_io_table(const std::filesystem::path& file, const DriveTable& drives);

/// The EDS file of each node of the table `file`, in its order. Throws ConfigurationError.
std::vector<std::filesystem::path> io_eds_files(const std::filesystem::path& file);

}  // namespace mrroc::config
