#pragma once

#include <memory>

#include "sensors/force_torque/gauges.hpp"
#include "vsp/source.hpp"

namespace mrroc::vsp {

/// The simulated world's wrist as a strain-gauge transducer: converts the wrench s of `wrench_source`, with which the
/// wrist supports the tool (N, N m), to the voltages of the gauges under the load -s, saturated ones included. An
/// incomplete wrench passes unchanged.
class SimulatedGauges final : public Source {
 public:
  SimulatedGauges(const Gauges& gauges, std::unique_ptr<Source> wrench_source)
      : gauges_(gauges), wrench_source_(std::move(wrench_source)) {}

  SourceState read(Tick wanted, RawReading& raw) noexcept override {
    const SourceState state = wrench_source_->read(wanted, raw);
    if (state != SourceState::ready || raw.count != 6) return state;
    Eigen::Map<Wrench> values(raw.values.data());
    if (values.allFinite()) values = gauges_.voltages(-values);  // a maximum would turn NaN into a number
    return state;
  }

 private:
  Gauges gauges_;
  std::unique_ptr<Source> wrench_source_;
};

}  // namespace mrroc::vsp
