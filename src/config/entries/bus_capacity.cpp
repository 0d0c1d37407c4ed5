#include "config/entries/bus_capacity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "config/drives/bus_load.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

/// Those of CiA 301.
constexpr std::array<std::int64_t, 8> kBitRates{10'000, 20'000, 50'000, 125'000, 250'000, 500'000, 800'000, 1'000'000};

std::string expected_rate(double needed) {
  const auto found = std::find_if(kBitRates.begin(), kBitRates.end(),
                                  [needed](std::int64_t rate) { return static_cast<double>(rate) >= needed; });
  std::string text = "fewer axes on the bus or a longer servo_period";
  if (found != kBitRates.end()) text = std::to_string(*found) + ", or " + text;
  return text;
}

void check_rate(const Table& can, std::int64_t rate) {
  if (std::find(kBitRates.begin(), kBitRates.end(), rate) == kBitRates.end())
    can.fail("bit_rate", std::to_string(rate) + " is not a bit rate of CiA 301",
             "10000, 20000, 50000, 125000, 250000, 500000, 800000 or 1000000");
}

}  // namespace

void check_bus_capacity(const Table& can, double period, const std::vector<BusNodes>& all) {
  const auto rate_of = [](const BusNodes& nodes) { return std::llround(nodes.robot.driver.number("bit_rate")); };
  const std::int64_t rate = rate_of(all.back());
  if (rate == 0) return;
  check_rate(can, rate);
  BusLoad sum;
  std::size_t axes = 0;
  for (const BusNodes& nodes : all) {
    if (const std::int64_t other = rate_of(nodes); other != 0 && other != rate)
      can.fail("bit_rate",
               std::to_string(rate) + ", but " + std::to_string(other) + " of robot " + in_quotes(nodes.robot.name) +
                   " on the same bus",
               "one bit rate");
    const BusLoad load = bus_load(nodes.drives, nodes.io, period);
    sum.cycle += load.cycle;
    sum.per_second += load.per_second;
    axes += nodes.drives.drives.size();
  }
  // one frame may be under way before the SYNC
  const double cycle = (sum.cycle + frame_bits(8)) / period;
  const double needed = std::max(cycle, sum.per_second);
  if (needed <= static_cast<double>(rate)) return;
  can.fail("bit_rate",
           std::to_string(rate) + " is too slow: at a servo period of " + number_text(period) + " s the frames of " +
               std::to_string(axes) + (axes == 1 ? " axis" : " axes") + " take up to " +
               std::to_string(std::llround(needed)) + " bit/s",
           expected_rate(needed));
}

}  // namespace mrroc::config
