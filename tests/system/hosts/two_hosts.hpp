#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "system/hosts/cable.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test {

// exit codes of `mrroc run`
inline constexpr int kUsage = 2;
inline constexpr int kHardware = 3;
inline constexpr int kSystem = 4;

inline void pause_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// A busy machine may be silent for longer than the usual 40 ms (link_timeout).
inline constexpr const char* kPatientLink = "link_timeout = 2\n";

/// The operator and the MP on host a, robot, sensors and simulated world on host b, called `cell`.
class TwoHosts : public testing::Test {
 protected:
  void SetUp() override;
  /// Keys are the default of deployments with hosts, and cost a second; only behaviour that depends on keys is tested
  /// with them.
  virtual bool with_keys() const { return false; }

  /// The common part of the deployments; `limits` are more lines of [deployment], `more` of [hosts.cell].
  std::string hosts(const std::string& name, const std::string& limits, std::vector<std::string> command = {},
                    const std::string& more = "") const;
  /// The task press_mp: every step is sent over the cable.
  static std::string press();
  /// A robot with loopback drives whose task never ends.
  static std::string hold();
  /// A simulated arm whose task, on its own host, moves it to and fro in an endless loop.
  static std::string to_and_fro();

  std::filesystem::path write(const std::string& text) const { return folder_.write("two.toml", text); }
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }
  MrrocRun& start(const std::filesystem::path& deployment, const std::vector<std::string>& options = {});
  /// Starts, and waits until this text is printed. With keys it starts up to three times: a busy host loses messages of
  /// hand-shakes, and then some processes do not discover each other (docs/how-to/two-hosts.md).
  MrrocRun& start_until(const std::string& printed, const std::filesystem::path& deployment,
                        const std::vector<std::string>& options = {});
  std::string output() const { return run_->out() + run_->err(); }

  /// Checks that the run ends with this code, that its last output contains `cause`, or one of `causes`, and that no
  /// process remains on either host.
  void expect_end(int code, const std::string& cause, const std::vector<pid_t>& pids) {
    expect_end(code, std::vector<std::string>{cause}, pids);
  }
  void expect_end(int code, const std::vector<std::string>& causes, const std::vector<pid_t>& pids);

  ScratchFolder folder_;
  std::optional<Cable> cable_;
  std::optional<MrrocRun> run_;
};

class TwoHostsWithKeys : public TwoHosts {
  bool with_keys() const override { return true; }
};

}  // namespace mrroc::test
