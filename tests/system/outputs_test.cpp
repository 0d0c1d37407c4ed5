// The files of a run are complete and belong to one run, or the run is refused before its start; signals end it at any
// time.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::outputs_test {
namespace {

constexpr int kUsage = 2;
constexpr int kSystem = 4;
constexpr int kStopped = 5;

/// A deployment that takes a second in lockstep.
std::string short_deployment() {
  return "[deployment]\nname = \"short\"\n[robots.arm]\ntype = \"irb6\"\nprogram = \"irb6_demo\"\nhardware = "
         "\"loopback\"\n";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Outputs : public testing::Test {
 protected:
  Outputs()
      : hold(folder_.write("hold.toml", faulty_deployment("hold", "real"))),
        brief(folder_.write("short.toml", short_deployment())) {}

  std::filesystem::path at(const std::string& name) const { return folder_.path() / name; }
  /// Runs a script of bash in the folder, with $MRROC, $HOLD and $SHORT, for a minute at most. Returns its exit code;
  /// its output is in `said`.
  int bash(const std::string& script) {
    const std::string file = folder_.write("script", script).string();
    const std::string command = "cd '" + folder_.path().string() +
                                "' && export SHORT=short.toml MRROC='" MRROC_BINARY_DIR
                                "/bin/mrroc' && timeout --kill-after=5 60 bash '" +
                                file + "' > said 2>&1 < /dev/null";
    const int status = std::system(command.c_str());
    output = text_of(at("said"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& reason) {
    MrrocRun run(arguments);
    EXPECT_EQ(run.wait(), kUsage) << run.err();
    EXPECT_TRUE(has(run.err(), reason)) << run.err();
    EXPECT_FALSE(has(run.out(), "ready")) << run.out();
  }

  ScratchFolder folder_;
  const std::filesystem::path hold, brief;
  std::string output;
};

TEST_F(Outputs, RunIsRefusedAFileThatAnotherOneWrites) {
  MrrocRun first({"run", hold.string(), "--record", at("t").string()});
  ASSERT_TRUE(first.wait_for_output("running")) << first.err();
  std::filesystem::create_symlink(at("t"), at("link"));
  std::filesystem::create_hard_link(at("t"), at("twin"));
  const std::string reason = "is being written by process " + std::to_string(first.pid());
  for (const char* name : {"t", "./t", "link", "twin"})
    expect_refused({"run", brief.string(), "--record", at(name).string()}, reason);
  first.signal(SIGINT);
  EXPECT_EQ(first.wait(), kStopped) << first.err();
  expect_laws(at("t"));
  EXPECT_FALSE(text_of(at("t")).empty());
  run_mrroc({"run", brief.string(), "--quiet", "--record", at("t").string()}, 0);
}

TEST_F(Outputs, SimulatorsFilesAreClaimedToo) {
  const std::string task = "tasks/draw/draw.toml";
  MrrocRun first({"run", task, "--clock", "real", "--motion", at("m").string(), "--snapshots", at("s").string()});
  ASSERT_TRUE(first.wait_for_output("running")) << first.err();
  const std::string reason = "is being written by process " + std::to_string(first.pid());
  expect_refused({"run", task, "--motion", at("m").string()}, reason);
  expect_refused({"run", task, "--snapshots", at("s").string() + "/."}, reason);
  expect_refused({"run", task, "--record", at("m").string()}, reason);
  first.signal(SIGKILL);
  first.wait();
  const auto free = [&] {
    return MrrocRun({"run", task, "--motion", at("m").string(), "--record", "/no/such/t"}).wait();
  };
  EXPECT_EQ(free(), kUsage) << "for the recording, not for the motion file of a killed run";
}

TEST_F(Outputs, KilledRunDoesNotBlockAnother) {
  MrrocRun first({"run", hold.string(), "--record", at("t").string()});
  ASSERT_TRUE(first.wait_for_output("running")) << first.err();
  const std::vector<pid_t> pids = first.children();
  first.signal(SIGKILL);
  first.wait();
  ASSERT_TRUE(all_end(pids));
  run_mrroc({"run", brief.string(), "--quiet", "--record", at("t").string()}, 0);
}

TEST_F(Outputs, TwoSimultaneousRunsAreCompleteOrRefused) {
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(
        bash(
            R"(for i in 1 2 3; do $MRROC run $SHORT --quiet --record same --black-box "" > out$i 2>&1 & pid[$i]=$!; done
      good=0; for i in 1 2 3; do wait ${pid[$i]}; rc=$?; test $rc = 0 -o $rc = 2 || exit 9; test $rc = 0 && good=$((good + 1)); done
      test $good -ge 1 && $MRROC trace check same)"),
        0)
        << output;
  }
}

TEST_F(Outputs, SameFileTwiceIsRefused) {
  const std::string text = text_of(brief);
  expect_refused({"run", brief.string(), "--record", brief.string()}, "is also the file of deployment");
  std::filesystem::create_symlink(brief, at("link"));
  expect_refused({"run", brief.string(), "--record", at("link").string()}, "is also the file of deployment");
  expect_refused({"run", brief.string(), "--motion", brief.string()}, "is also the file of deployment");
  expect_refused({"run", brief.string(), "--record", at("x").string(), "--motion", at("./x").string()}, "--motion");
  expect_refused({"run", brief.string(), "--record", at("y").string(), "--black-box", at("y").string()}, "--record");
  expect_refused({"run", brief.string(), "--record", "tasks/draw/draw.toml", "--record", at("x").string()}, "--record");
  EXPECT_EQ(text_of(brief), text);
}

TEST_F(Outputs, StreamGetsTheWholeRecording) {
  ASSERT_EQ(bash(R"($MRROC run $SHORT --quiet --record t)"), 0) << output;
  const std::string trace = text_of(at("t"));
  EXPECT_EQ(bash(R"(mkfifo f; cat f > got & $MRROC run $SHORT --quiet --record f || exit; wait; cmp t got)"), 0)
      << output;
  EXPECT_EQ(bash(R"((sleep 2; cat f > got) & $MRROC run $SHORT --quiet --record f || exit; wait; cmp t got)"), 0)
      << "a late reader: " << output;
  EXPECT_EQ(bash(R"($MRROC run $SHORT --quiet --record >(gzip > got.gz) || exit; sleep 0.5; zcat got.gz | cmp t -)"), 0)
      << output;
  EXPECT_EQ(
      bash(R"($MRROC run $SHORT --record /dev/stdout > got 2> progress || exit; cmp t got && grep -q ready progress)"),
      0)
      << output;
  EXPECT_EQ(bash(R"($MRROC run $SHORT --record /dev/stdout 2> progress | cmp t -)"), 0) << output;
  EXPECT_EQ(bash(R"(echo first > got; exec 3>> got; $MRROC run $SHORT --quiet --record /dev/fd/3 || exit; exec 3>&-
      tail -n +2 got | cmp t - && head -1 got | grep -q first)"),
            0)
      << output;
  EXPECT_EQ(bash(R"($MRROC run $SHORT --quiet --record /dev/null)"), 0) << output;
}

TEST_F(Outputs, TextOfTheRunInItsRecordingIsRefused) {
  EXPECT_EQ(bash(R"($MRROC run $SHORT --record /dev/stdout > got 2>&1; test $? = 2 && ! grep -q MCAP got)"), 0)
      << output;
  EXPECT_EQ(bash(R"($MRROC run $SHORT --record log > out 2> log; test $? = 2)"), 0) << output;
}

TEST_F(Outputs, SignalsEndARunWhoseRecordingHasNoReader) {
  for (const char* signal : {"INT", "TERM", "HUP"}) {
    EXPECT_EQ(
        bash(std::string{
                 R"(mkfifo f 2> /dev/null; set -m; $MRROC run $SHORT --quiet --record f & pid=$!; sleep 1; kill -)"} +
             signal + R"( $pid; wait $pid; test $? = 5)"),
        0)
        << signal << output;
  }
  EXPECT_EQ(
      bash(
          R"(sed '/^name/a start_timeout = 1' $SHORT > soon.toml; mkfifo g; $MRROC run soon.toml --record g; test $? = 2)"),
      0)
      << output;
  EXPECT_TRUE(has(output, "no process reads the FIFO")) << output;
}

TEST_F(Outputs, SignalsEndARunWhoseReaderHasStopped) {
  EXPECT_EQ(bash(R"(export TMPDIR=$PWD; mkfifo f; sleep 50 < f & reader=$!
      set -m; $MRROC run $SHORT --record f > log 2>&1 & pid=$!
      for i in $(seq 100); do kill -0 $pid || break; pgrep -P $pid > /dev/null && started=1
        test "$started" && ! pgrep -P $pid > /dev/null && break; sleep 0.1; done
      sleep 0.5; kill -0 $pid || exit 8; kill -INT $pid; wait $pid; rc=$?; kill $reader; cat log; test $rc = 5)"),
            0)
      << output;
}

TEST_F(Outputs, OneSignalDuringTheTaskEndsARunWhoseReaderHasStopped) {
  EXPECT_EQ(bash(R"(export TMPDIR=$PWD; mkfifo f; sleep 50 < f & reader=$!
      set -m; $MRROC run $SHORT --record f --clock real > log 2>&1 & pid=$!
      for i in $(seq 100); do grep -q "arm .*step" log && break; sleep 0.1; done
      kill -TERM $pid; wait $pid; rc=$?; kill $reader; cat log; test $rc = 5)"),
            0)
      << output;
}

TEST_F(Outputs, ReaderThatLeavesIsAnError) {
  EXPECT_EQ(
      bash(R"(export TMPDIR=$PWD; mkfifo f; head -c 10 f > got & $MRROC run $SHORT --quiet --record f; test $? = 4)"),
      0)
      << output;
  EXPECT_TRUE(has(output, "cannot write the recording f: Broken pipe; it is in ")) << output;
  EXPECT_EQ(bash(R"(mkdir -p kept; export TMPDIR=$PWD/kept; head -c 10 f > got & $MRROC run $SHORT --quiet --record f
      ls kept/mrroc-*.part && $MRROC trace check kept/mrroc-*.part)"),
            0)
      << output;
}

TEST_F(Outputs, FullDiskAndFileSizeLimitEndTheRun) {
  EXPECT_EQ(bash(R"($MRROC run $SHORT --quiet --record /dev/full)"), kSystem) << output;
  EXPECT_TRUE(has(output, "mrroc: short: cannot write the recording /dev/full: No space left on device")) << output;
  EXPECT_EQ(bash(R"(ulimit -f 1; $MRROC run $SHORT --quiet --record t)"), kSystem) << output;
  EXPECT_TRUE(has(output, "file size limit")) << output;
  // enough for the memory that the processes share and for a part of the recording, not for the whole
  EXPECT_EQ(bash("ulimit -f 4000; cd " MRROC_SOURCE_DIR
                 "; $MRROC run tasks/draw/draw.toml --quiet --black-box none --record $OLDPWD/t --record-rate servo"),
            kSystem)
      << output;
  EXPECT_TRUE(has(output, "mrroc: draw: cannot write the recording " + at("t").string() + ": File too large"))
      << output;
  EXPECT_FALSE(std::filesystem::exists(at("mrroc-black-box"))) << "no task has failed";
}

TEST_F(Outputs, IncompleteMotionFileIsAnError) {
  EXPECT_EQ(
      bash("cd " MRROC_SOURCE_DIR "; $MRROC run tasks/draw/draw.toml --quiet --black-box \"\" --motion /dev/full"),
      kSystem)
      << output;
  EXPECT_TRUE(has(output, "cannot write the motion file /dev/full: No space left on device")) << output;
}

TEST_F(Outputs, BlackBoxIsNeverOverwritten) {
  folder_.write("fail.toml", faulty_deployment("exception"));
  EXPECT_EQ(
      bash(
          R"(for i in 1 2 3; do $MRROC run fail.toml --quiet & done; wait; $MRROC run fail.toml --quiet; ls mrroc-black-box)"),
      0)
      << output;
  for (const char* name : {"exception-arm", "exception-arm-2", "exception-arm-3", "exception-arm-4"})
    EXPECT_TRUE(std::filesystem::exists(at("mrroc-black-box") / (std::string{name} + ".mcap"))) << name << output;
  EXPECT_TRUE(has(output, "black box: mrroc-black-box/exception-arm-4.mcap")) << output;
}

TEST_F(Outputs, DeploymentMayComeFromAStream) {
  for (const char* command :
       {"$MRROC run /dev/stdin --quiet < $SHORT", "cat $SHORT | $MRROC run - --quiet",
        "$MRROC run <(cat $SHORT) --quiet", "exec 4< $SHORT; $MRROC run /dev/fd/4 --quiet",
        "mkfifo p; cat $SHORT > p & $MRROC run p --quiet", "$MRROC run --check - < $SHORT | grep -q irb6"})
    EXPECT_EQ(bash(command), 0) << command << output;
  EXPECT_EQ(bash("echo 'name = ' | $MRROC run - --quiet"), kUsage) << output;
  EXPECT_TRUE(has(output, "/stdin:1")) << output;
  EXPECT_EQ(bash("$MRROC run - --quiet < /dev/zero"), kUsage) << output;
  EXPECT_EQ(bash("$MRROC run . --quiet"), kUsage) << output;
}

TEST_F(Outputs, EveryProcessReadsTheDeploymentThatTheRunnerHasRead) {
  MrrocRun run({"run", brief.string(), "--shuffle-start", "3"});
  while (run.children().empty() && !run.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::filesystem::remove(brief);
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
}

TEST_F(Outputs, OutputToAFullDiskFails) {
  ASSERT_EQ(bash("$MRROC run $SHORT --quiet --record t"), 0) << output;
  for (const char* words : {"run --check $SHORT", "trace hash t", "trace check t", "trace check --rules", "--help",
                            "run --help", "--version", "keys k"})
    EXPECT_EQ(bash(std::string{"$MRROC "} + words + " > /dev/full"), kSystem) << words << output;
}

TEST_F(Outputs, OptionsAreUsedAsTheyAreWritten) {
  EXPECT_EQ(bash(R"($MRROC run $SHORT --quiet --black-box= --record t && test -s t)"), 0) << output;
  EXPECT_EQ(bash(R"($MRROC run --record= --black-box= $SHORT --quiet)"), 0) << output;
  EXPECT_EQ(bash("$MRROC --version | grep -qx 'mrroc " MRROC_VERSION "'"), 0) << output;
  for (const char* program : {"mrroc_sim", "mrroc_mp", "mrroc_ecp", "irb6_edp", "irb6_drives", "irb6_demo",
                              "mrroc_render", "press_ecp", "force_torque_vsp", "camera_marker"})
    EXPECT_EQ(bash(std::string{MRROC_BINARY_DIR "/bin/"} + program + " --version | grep -q '" + program +
                   " (MRROC++) " MRROC_VERSION "'"),
              0)
        << program << output;
  for (const char* words : {"--shuffle-start -1", "--shuffle-start 1.5", "--shuffle-start 18446744073709551616",
                            "--shuffle-start=", "--quiet=no", "--record a --record b", "--record a --trace b",
                            "--unknown", "--clock fast", "--clock="})
    EXPECT_EQ(bash(std::string{"$MRROC run $SHORT --check "} + words), kUsage) << words << output;
  EXPECT_EQ(bash("$MRROC can scan can0 --patience nan"), kUsage) << output;
  EXPECT_EQ(bash("$MRROC can monitor can0 --count -5"), kUsage) << output;
}

TEST_F(Outputs, TooFewOpenFilesAreNamed) {
  for (const int limit : {8, 12, 16, 22, 30, 40, 50, 60, 80}) {
    const int code = bash("ulimit -n " + std::to_string(limit) + "; $MRROC run $SHORT --quiet --record t");
    EXPECT_TRUE(code == 0 || code == kUsage || code == kSystem) << limit << ": " << code << output;
    EXPECT_TRUE(code == 0 || has(output, "open files")) << limit << output;
    EXPECT_FALSE(has(output, "died")) << limit << output;
  }
}

TEST_F(Outputs, ControlCharactersAreEscaped) {
  EXPECT_EQ(bash(R"($MRROC run $'no\e[31m.toml' || $MRROC $'\e[31m' || $MRROC run $SHORT --record $'/no/\e[31m/t' ||
      $MRROC trace hash $'\e[31m' || printf 'name = "\033[31m"\n' | $MRROC run -)"),
            kUsage);
  EXPECT_FALSE(has(output, "\x1b")) << output;
  EXPECT_TRUE(has(output, "\\x1b[31m")) << output;
}

}  // namespace
}  // namespace mrroc::test::outputs_test
