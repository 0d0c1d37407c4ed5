#pragma once

#include <vector>

#include "config/drives/io_table.hpp"

namespace mrroc::edp {

/// The settings written into an I/O node before it is started, in this order: its PDOs, heartbeats, the state of its
/// outputs when it loses its master, then the table's own settings. Of optional objects, only those that its EDS file
/// has as writable.
///
/// Inputs are sent at each `status_every`-th SYNC of `drives`, outputs are taken when they come. An output without an
/// error value in the table's `objects` goes off, an analogue one to 0, when the node fails, is stopped or loses our
/// heartbeat.
std::vector<config::NodeSetting> io_settings(const config::IoEntry& node, const config::DriveTable& drives);

}  // namespace mrroc::edp
