// One VSP with requests of the MP and two ECPs at the same time, each with its own period, and one that publishes for
// all of them. The programs check the order of a client's readings: programs/several_clients.hpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "system/client_looks.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::several_clients_test {
namespace {

/// Whether `time` is that of `tick`: since the last zero before it, or since a zero at the same tick.
bool is_time(double time, double tick, const std::set<double>& zeros) {
  const auto next = zeros.lower_bound(tick);
  const double last = next == zeros.begin() ? 0 : *std::prev(next);
  return std::abs(time - (tick - last) * 0.002) < 1e-12 || (zeros.contains(tick) && time == 0);
}

TEST(SeveralClients, EachReadsTheMeasurementsOfItsOwnSteps) {
  const ScratchFolder folder;
  const auto file = folder.write("clients.toml", clients_deployment("clients", kTime, kTime)),
             trace = folder.path() / "trace.mcap";
  std::set<std::string> hashes;
  std::string output;
  for (int i = 0; i < 3; ++i) {
    output = run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1u);

  std::set<double> zeros;  // a zero of one client applies to all
  for (const char* client : {"mp", "left"}) zeros.insert(number_after(output, client + std::string(" | zero at ")));
  std::map<double, std::set<std::string>> asked;
  const auto looks = looks_of(trace);
  ASSERT_EQ(looks.size(), 3u);
  for (const auto& [client, steps] : looks) {
    ASSERT_EQ(steps.size(), 3u * 31) << client;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Look& look = steps[i];
      SCOPED_TRACE(client + " step " + std::to_string(look.step) + " tick " + std::to_string(look.own));
      const bool due = static_cast<int>(look.step) % kPeriods.at(client) == 0;
      EXPECT_EQ(look.shared, due ? look.own : steps[i - 1].shared);
      EXPECT_EQ(look.free, kPublished * std::floor(look.own / kPublished)) << "it is not the newest";
      EXPECT_TRUE(is_time(look.value, look.shared, zeros)) << look.value;
      if (due) asked[look.own].insert(client);
    }
    EXPECT_GT(steps.back().shared, *zeros.rbegin());
  }
  EXPECT_GT(std::count_if(asked.begin(), asked.end(), [](const auto& tick) { return tick.second.size() > 1; }), 10)
      << "two clients hardly ever request the same tick";
}

}  // namespace
}  // namespace mrroc::test::several_clients_test
