#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "canopen/drive_state.hpp"
#include "canopen/objects.hpp"
#include "canopen/sdo.hpp"
#include "edp/safety/fault.hpp"

namespace mrroc::edp {

/// The drive has booted again, or reports that it is not operational.
struct Restarted {
  static constexpr ErrorCode kCode = ErrorCode::drive_restarted;
};

/// The drive rejects a value of its set-up after a restart.
struct SetupRefused {
  static constexpr ErrorCode kCode = ErrorCode::drive_restarted;
  canopen::Object object;
  canopen::SdoAbort reason{};
};

/// More answers than SYNCs in `cycles` cycles in a row: two nodes have the same number.
struct DuplicateNode {
  static constexpr ErrorCode kCode = ErrorCode::encoder_fault;
  int cycles = 0;
};

/// More than `allowed` SYNCs in a row without the expected PDO.
struct Silent {
  static constexpr ErrorCode kCode = ErrorCode::hardware_silent;
  enum class How : std::uint8_t {
    no_answer,
    late,      ///< the answers arrive too late
    no_status  ///< no PDO of velocity and switches
  };
  How how = How::no_answer;
  int allowed = 0;
};

/// The last heartbeat is too old; ticks.
struct HeartbeatLost {
  static constexpr ErrorCode kCode = ErrorCode::heartbeat_lost;
  Tick age = 0, allowed = 0;
};

/// The drive is in a fault; `code` is the error code of its EMCY (603Fh), 0 without one.
struct DriveError {
  static constexpr ErrorCode kCode = ErrorCode::drive_fault;
  std::uint16_t code = 0;
};

/// The drive is not in the commanded state.
struct WrongState {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
  std::uint16_t statusword = 0;
};

/// The drive is in another mode, or does not report one.
struct WrongMode {
  static constexpr ErrorCode kCode = ErrorCode::drive_not_ready;
  std::optional<int> shown;
  canopen::DriveMode wanted{};
};

/// The drive reports a following error (bit 13 of its statusword).
struct NotFollowing {
  static constexpr ErrorCode kCode = ErrorCode::following_error;
};

/// A fault of a drive; monostate: none.
using DriveFault = std::variant<std::monostate, Restarted, SetupRefused, DuplicateNode, Silent, HeartbeatLost,
                                DriveError, WrongState, WrongMode, NotFollowing>;

/// `kCode` of the alternative; `none` without a fault.
ErrorCode code_of(const DriveFault& fault) noexcept;

/// Text of the fault; empty when the code is sufficient. Allocates nothing, never throws.
DriverText describe(const DriveFault& fault) noexcept;

}  // namespace mrroc::edp
