#pragma once

#include <filesystem>
#include <vector>

#include "core/text_lines.hpp"
#include "vsp/source.hpp"
#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Hardware readings played from a text file (docs/reference/sensors.md):
///
///     # mrroc readings range
///     # comments and empty lines are allowed below the first line
///     0    -1
///     250  0.62
///     500  0.08
///
/// The first line names the sensor's raw channels in order; each line below is a tick and one number per channel,
/// ticks strictly increasing. The value at tick k is that of the last line with tick <= k: not ready before the first
/// line, and the last line holds forever. `nan` plays failed hardware. `#` at the start of a line or after a
/// blank begins a comment. Allowed text around a line: core/text_lines.hpp; numbers: core/number_text.hpp.
class ReplaySource final : public Source {
 public:
  /// Reads the whole file. Throws ConfigurationError (file, line, column, what is wrong, what was expected) when it
  /// does not follow the format above or has other channels.
  ReplaySource(const std::filesystem::path& file, const std::vector<Channel>& raw_channels);

  SourceState read(Tick wanted, RawReading& raw) noexcept override;

 private:
  void read(const std::filesystem::path& file, core::TextLines lines, const std::vector<Channel>& channels);

  std::size_t channel_count_;
  std::vector<Tick> ticks_;
  std::vector<double> values_;  ///< channel_count_ per tick
};

}  // namespace mrroc::vsp
