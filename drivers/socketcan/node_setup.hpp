#pragma once

#include <vector>

#include "canopen/sdo.hpp"
#include "config/drives/node_objects.hpp"

namespace mrroc::edp {

/// Writes the settings into a node, one after the other, without waiting: its owner sends the requests and passes the
/// answers to it. So a node that has restarted can be set up during normal operation of the others. Allocates in the
/// constructor only; never throws.
class NodeSetup {
 public:
  enum class Status : std::uint8_t { idle, writing, done, refused };

  NodeSetup(canopen::NodeId node, std::vector<config::NodeSetting> settings);

  /// Begins again; returns the first request.
  can::Frame start() noexcept;
  /// The same, but first reads whether the node still has an earlier set-up: the period of its heartbeat.
  can::Frame resume() noexcept;
  /// The read period differs: the node has restarted since. Without this check, values that a node stores without
  /// power (1010h) would hide the restart.
  bool forgotten() const noexcept { return forgotten_; }
  /// The request under way once more: it was lost, or its answer was. A value of more than four bytes begins again.
  can::Frame again() noexcept { return looks_ ? poll() : request(); }
  /// Takes a frame. True: it was an answer; `next` is to be sent when it has an identifier.
  bool take(const can::Frame& frame, can::Frame& next) noexcept;
  /// Stops the set-up.
  void give_up() noexcept { status_ = Status::idle; }

  Status status() const noexcept { return status_; }
  /// The present setting, or the rejected one.
  const config::NodeSetting& setting() const noexcept { return settings_[place_]; }
  canopen::SdoAbort abort() const noexcept { return transfer_.abort(); }

 private:
  can::Frame request() noexcept;
  can::Frame poll() noexcept;

  canopen::NodeId node_;
  std::vector<config::NodeSetting> settings_;
  std::size_t place_ = 0;
  Status status_ = Status::idle;
  bool looks_ = false, forgotten_ = false;
  canopen::SdoTransfer transfer_;
};

}  // namespace mrroc::edp
