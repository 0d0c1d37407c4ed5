#pragma once

#include <memory>
#include <vector>

#include "faults/fault_plan.hpp"
#include "vsp/source.hpp"

namespace mrroc::vsp {

/// Sensor hardware with injected faults: falsifies the readings of the real source while a fault is in force.
class FaultySource final : public Source {
 public:
  FaultySource(std::unique_ptr<Source> source, std::vector<faults::FaultSwitch> faults)
      : source_(std::move(source)), faults_(std::move(faults)) {}

  SourceState read(Tick wanted, RawReading& raw) noexcept override;
  std::string_view fault() const noexcept override { return source_->fault(); }

 private:
  std::unique_ptr<Source> source_;
  std::vector<faults::FaultSwitch> faults_;
  RawReading last_;  ///< ready, as given before
};

}  // namespace mrroc::vsp
