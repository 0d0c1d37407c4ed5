#pragma once

#include <algorithm>

namespace mrroc::edp {

/// Counts the answers of a drive to the SYNCs: one TPDO 1 per SYNC, one TPDO 2 per `status_every` SYNCs.
///
/// A cycle is `expect`, any number of `take` and `take_status`, `close`. A TPDO 1 that arrives after `close` counts for
/// the next cycle: the drive is alive, but its feedback is too late to regulate with. One thread; allocates nothing,
/// never throws.
class DriveAnswers {
 public:
  /// What was received in a cycle.
  enum class Cycle {
    nothing,   ///< no answer in time
    answer,    ///< the expected one
    too_many,  ///< more answers than SYNCs: two nodes have the same number, and either may be wrong
  };

  DriveAnswers(int missed_max, int status_every) noexcept
      : missed_max_(missed_max), without_status_max_(status_every * (missed_max + 1)) {}

  /// The drive is in service: from now on it answers every SYNC. The answer of this cycle is not expected.
  void begin() noexcept;
  /// The drive is out of service.
  void end() noexcept { in_service_ = false; }
  bool in_service() const noexcept { return in_service_; }

  void expect() noexcept;
  /// A TPDO 1. True: the first one of this cycle.
  bool take() noexcept;
  void take_status() noexcept;
  Cycle close() noexcept;
  /// Clears `has_duplicate`.
  void clear() noexcept { surplus_ = 0; }

  bool answered() const noexcept { return answered_; }
  /// A TPDO 1 has arrived in this cycle, in time or not.
  bool answered_this_cycle() const noexcept { return answered_this_cycle_; }
  /// The last SYNC was missed, but not more than `missed_max` in a row.
  bool may_extrapolate() const noexcept { return in_service_ && !answered_ && missed_ <= missed_max_; }
  /// Answers arrive, in time or not.
  bool is_alive() const noexcept { return in_service_ && unheard_ <= missed_max_; }
  /// More than `missed_max` SYNCs in a row without an answer in time.
  bool is_missed() const noexcept { return missed_ > missed_max_ || !in_service_; }
  bool knows_switches() const noexcept { return knows_switches_; }
  bool reports_switches() const noexcept { return without_status_ <= without_status_max_; }
  bool has_duplicate() const noexcept { return surplus_ > missed_max_; }
  int surplus() const noexcept { return surplus_; }  ///< cycles in a row with too many answers
  int missed_max() const noexcept { return missed_max_; }
  int without_status_max() const noexcept { return without_status_max_; }

 private:
  static constexpr int kMaxOutstanding = 16;  // answers under way on the slowest of buses

  int missed_max_, without_status_max_;
  bool in_service_ = false, answered_ = false, knows_switches_ = false;
  bool answered_this_cycle_ = false, unexpected_ = false;
  int outstanding_ = 0;     ///< answers that may still arrive
  int missed_ = 0;          ///< SYNCs in a row without an answer in time
  int unheard_ = 0;         ///< SYNCs in a row without any answer
  int without_status_ = 0;  ///< SYNCs since the last TPDO 2
  int surplus_ = 0;
};

}  // namespace mrroc::edp
