#include "system/equal_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "cli/trace/mutations.hpp"
#include "repetitions.hpp"

namespace mrroc::test {

EqualRuns expect_equal_runs(const std::string& deployment, const ScratchFolder& folder, int timeout) {
  const int runs = tries(2, 10);
  const auto trace = [&folder](int run) { return folder.path() / ("trace_" + std::to_string(run) + ".mcap"); };
  EqualRuns left{{}, trace(0), folder.path() / "states"};
  std::filesystem::create_directory(left.states);
  std::set<std::string> hashes;
  for (int first = 0; first < runs; first += 2) {  // two at a time, on two cores
    std::vector<std::unique_ptr<MrrocRun>> pair;
    for (int run = first; run < std::min(first + 2, runs); ++run) {
      std::vector<std::string> arguments{"run",      deployment, "--quiet",          "--clock",
                                         "lockstep", "--record", trace(run).string()};
      if (run == 0) arguments.insert(arguments.end(), {"--snapshots", left.states.string()});
      pair.push_back(std::make_unique<MrrocRun>(arguments, 1 + run - first));
    }
    for (std::size_t i = 0; i < pair.size(); ++i) {
      EXPECT_EQ(pair[i]->wait(timeout), 0) << pair[i]->out() << pair[i]->err();
      left.outputs.push_back(pair[i]->out());
      const int run = first + static_cast<int>(i);
      hashes.insert(trace_hash(trace(run)));
      if (run != 0) std::filesystem::remove(trace(run));
    }
  }
  EXPECT_EQ(hashes.size(), 1U) << testing::PrintToString(left.outputs);
  expect_laws(left.trace);
  cli::trace::read_trace(left.trace).write(folder.path() / "again.mcap");
  EXPECT_EQ(trace_hash(folder.path() / "again.mcap"), *hashes.begin()) << "every field is read to the last bit";
  return left;
}

}  // namespace mrroc::test
