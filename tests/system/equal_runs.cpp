#include "system/equal_runs.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "cli/trace/mutations.hpp"
#include "repetitions.hpp"
#include "text_of.hpp"

namespace mrroc::test {

EqualRuns expect_equal_runs(const std::string& deployment, const ScratchFolder& folder, int patience) {
  const auto trace = [&folder](int run) { return folder.path() / ("trace_" + std::to_string(run)); };
  EqualRuns left{{}, trace(0), folder.path() / "states"};
  std::filesystem::create_directory(left.states);
  std::set<std::string> hashes;
  const auto start = [&](int run, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run",      deployment, "--quiet",          "--clock",
                                       "lockstep", "--trace",  trace(run).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::make_unique<MrrocRun>(arguments, 1 + run % 2);
  };
  const auto end = [&](int run, MrrocRun& running) {
    EXPECT_EQ(running.wait(patience), 0) << running.out() << running.err();
    left.outputs.push_back(running.out());
    hashes.insert(trace_hash(trace(run)));
    if (run != 0) std::filesystem::remove(trace(run));
  };
  {
    const auto first = start(0, {"--snapshots", left.states.string()});
    const auto beside = start(1, {});
    end(0, *first);
    end(1, *beside);
  }
  if (!kSanitized) end(2, *start(2, {}));
  EXPECT_EQ(hashes.size(), 1U);
  expect_laws(left.trace);
  EXPECT_EQ(cli::trace::read_trace(left.trace).text(), text_of(left.trace)) << "every field is read to the last bit";
  return left;
}

}  // namespace mrroc::test
