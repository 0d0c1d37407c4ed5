#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <string>
#include <vector>

#include "robots/common/changed_file.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::wrong_input_test {
namespace {

constexpr int kTaskFailed = 1;
constexpr int kUsage = 2;
constexpr int kSystem = 4;

void expect_text(const std::string& output, const std::string& text) {
  EXPECT_NE(output.find(text), std::string::npos) << "'" << text << "' is missing in\n" << output;
}

void expect_nothing_moved(const std::string& output) { EXPECT_EQ(output.find("running"), std::string::npos) << output; }

void expect_nothing_started(const std::string& output) {
  EXPECT_EQ(output.find("starting"), std::string::npos) << output;
  EXPECT_EQ(output.find("ready"), std::string::npos) << output;
  expect_nothing_moved(output);
}

TEST(WrongInput, CommandLineIsRefused) {
  expect_text(run_mrroc({}, kUsage), "subcommand");
  expect_text(run_mrroc({"rum", "tasks/press/press.toml"}, kUsage), "did you mean 'run'?");
  expect_text(run_mrroc({"run"}, kUsage), "FILE is required");
  expect_text(run_mrroc({"run", "tasks/press/press.toml", "--clocks", "real"}, kUsage), "--clocks");
  expect_text(run_mrroc({"run", "tasks/press/press.toml", "--clock", "fast"}, kUsage), "fast");
  expect_text(run_mrroc({"run", "tasks/press/press.toml", "--shuffle-start", "soon"}, kUsage), "--shuffle-start");
  expect_text(run_mrroc({"run", "no/such/file.toml"}, kUsage), "no/such/file.toml");
  expect_text(run_mrroc({"run", "tasks/press"}, kUsage), "tasks/press");
}

TEST(WrongInput, RefusesAFileThatIsNotARecording) {
  const ScratchFolder folder;
  expect_text(run_mrroc({"trace", "hash", "README.md"}, kUsage), "README.md: is not an MCAP file");
  expect_text(run_mrroc({"trace", "hash", folder.write("empty", "").string()}, kUsage), "empty: is not an MCAP file");
  expect_text(run_mrroc({"trace", "hash", "no/such/trace"}, kUsage), "no/such/trace");
  expect_text(run_mrroc({"trace", "hash", "tasks"}, kUsage), "tasks");
}

TEST(WrongInput, ADeploymentIsRefusedWithItsLineAndNothingIsStarted) {
  const ScratchFolder folder;
  const auto file = folder.write("wrong.toml", "[deployment]\nname = \"wrong\"\nclock = \"fast\"\n");
  MrrocRun run({"run", file.string()});
  EXPECT_EQ(run.wait(), kUsage);
  expect_text(run.err(), "wrong.toml:3: deployment.clock: unknown value 'fast'");
  expect_nothing_started(run.out());
  expect_text(run_mrroc({"run", "--check", file.string()}, kUsage), "wrong.toml:3: deployment.clock");
}

TEST(WrongInput, OutputsReplaceNothingElse) {
  const ScratchFolder folder;
  const std::string task = folder.write("short.toml", faulty_deployment("exception")).string();
  const std::string events = "[[events]]\ntick = 5\ncommand = \"pause\"\n";
  const auto mine = folder.write("mine.toml", events);
  const auto other = folder.write("other.xml", "<mujocoinclude/>");
  for (const std::string option : {"--record", "--motion", "--note-events"}) {
    const auto refused = [&](const std::vector<std::string>& more, const std::string& text) {
      std::vector<std::string> words{"run", task, "--quiet", option};
      words.insert(words.end(), more.begin(), more.end());
      MrrocRun run(words);
      EXPECT_EQ(run.wait(), kUsage) << option;
      expect_text(run.err(), text);
    };
    refused({other.string()}, option);
    refused({mine.string(), "--events", mine.string()}, option);
    refused({task}, option);
    refused({"/dev/fd/9"}, "/dev/fd/9");
  }
  EXPECT_EQ(text_of(mine), events);
  EXPECT_EQ(text_of(other), "<mujocoinclude/>");
  EXPECT_EQ(text_of(task), faulty_deployment("exception"));
}

TEST(WrongInput, CheckLooksAtTheFaultsToo) {
  const std::string task = "tasks/press/press.toml";
  for (const char* fault : {"kill", "nan edp:arm axis 7 at tick 1", "kill edp:left at tick 1", "kill mp at step 0"})
    for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--check"}}) {
      std::vector<std::string> words{"run", task, "--inject", fault};
      words.insert(words.end(), more.begin(), more.end());
      expect_nothing_started(run_mrroc(words, kUsage));
    }
  run_mrroc({"run", task, "--check", "--inject", "nan edp:arm axis 6 at tick 1"}, 0);
}

TEST(WrongInput, CheckStartsNothing) {
  const std::string output = run_mrroc({"run", "--check", "tasks/press/press.toml"}, 0);
  expect_text(output, "press: lockstep");
  expect_nothing_started(output);
}

/// A valid deployment with an error that only its processes can detect.
TEST(WrongInput, SceneThatMuJoCoRejectsIsReportedWithItsMessageAndLine) {
  const ScratchFolder folder;
  folder.write("scene.xml",
               "<mujoco>\n  <compiler angle=\"radian\"/>\n  <worldbody>\n    <geom type=\"cylindre\" size=\"1 1\"/>\n  "
               "</worldbody>\n</mujoco>\n");
  const auto file =
      folder.write("scene.toml",
                   "[deployment]\nname = \"scene\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"mujoco\"\n"
                   "[sim]\nscene = \"scene.xml\"\n");
  for (const char* quiet : {"", "--quiet"}) {
    std::vector<std::string> words{"run", file.string()};
    if (*quiet != '\0') words.emplace_back(quiet);
    MrrocRun run(words);
    EXPECT_EQ(run.wait(), kUsage) << run.err();
    expect_text(run.err(), "process sim died: exit code 2: ");
    expect_text(run.err(), "scene.xml:4: MuJoCo: ");
    expect_text(run.err(), "cylindre");
    expect_nothing_moved(run.out());
  }
}

TEST(WrongInput, ReplayFileIsRefusedWithItsLine) {
  const ScratchFolder folder;
  folder.write("gate.txt", "# mrroc readings range\n0 4\n100 near\n");
  const auto file = folder.write("replay.toml",
                                 "[deployment]\nname = \"replay\"\n[robots.arm]\ntype = \"irb6\"\nhardware = "
                                 "\"loopback\"\n[sensors.gate]\ntype = \"ultrasonic\"\nsource = \"replay\"\nreplay = "
                                 "\"gate.txt\"\n");
  const std::string output = run_mrroc({"run", file.string()}, kUsage);
  expect_text(output, "process gate died: exit code 2: ");
  expect_text(output, "gate.txt:3: ");
  expect_nothing_moved(output);
}

/// Keys that are right each for itself: only the sensor's process knows that they do not fit together.
TEST(WrongInput, ContradictionsOfASensorAreRefusedAsAWrongFileIs) {
  const ScratchFolder folder;
  const std::string sensor =
      "[deployment]\nname = \"wrong\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n"
      "[sensors.gate]\nsource = \"replay\"\nreplay = \"gate.txt\"\n";
  folder.write("gate.txt", "# mrroc readings range\n0 4\n");
  const std::vector<std::array<std::string, 2>> wrong = {
      {"noise_max", "type = \"ultrasonic\"\nnoise_max = [0.1, 0.1, 0.1]\n"},
      {"rays", "type = \"ultrasonic\"\nrays = 1.5\n"},
      {"dead_zone", "type = \"ultrasonic\"\ndead_zone = 3.0\nmax_range = 2.0\n"},
      {"dead_zone", "type = \"infrared\"\ndead_zone = 0.9\nmax_range = 0.5\n"}};
  for (const auto& [key, lines] : wrong) {
    const std::string output = run_mrroc({"run", folder.write("wrong.toml", sensor + lines).string()}, kUsage);
    expect_text(output, "process gate died: exit code 2: ");
    expect_text(output, "sensors.gate." + key + ": ");
    expect_nothing_moved(output);
  }
}

TEST(WrongInput, DomainInUseIsReported) {
  const ScratchFolder folder;
  const std::string deployment = faulty_deployment("hold");
  const std::string name = "[deployment]\n";
  const auto file = folder.write("hold.toml", name + "domain = 97\n" + deployment.substr(name.size()));
  MrrocRun first({"run", file.string()});
  ASSERT_TRUE(first.wait_for_output("running")) << first.err();
  const std::string output = run_mrroc({"run", file.string()}, kUsage);
  expect_text(output, "DDS domain 97 is in use");
  expect_nothing_started(output);
  // with separate domains both run
  run_mrroc({"run", folder.write("own.toml", faulty_deployment("caught")).string(), "--quiet"}, 0);
}

TEST(WrongInput, UnwritableRecordingIsReportedBeforeAnythingStarts) {
  const std::string output = run_mrroc({"run", "tasks/press/press.toml", "--record", "/no/such/folder/r.mcap"}, kUsage);
  expect_text(output, "cannot write the recording /no/such/folder/r.mcap: No such file or directory");
  expect_nothing_started(output);
  expect_nothing_started(run_mrroc({"run", "tasks/press/press.toml", "--record", "tasks"}, kUsage));
}

TEST(WrongInput, RecordingThatIsLostIsAnErrorAndNoPartOfItIsKept) {
  const ScratchFolder folder;
  const auto recording = folder.path() / "r.mcap";
  std::filesystem::create_symlink("/dev/full", recording);
  MrrocRun run({"run", "tasks/press_replay/press_replay.toml", "--quiet", "--record", recording});
  EXPECT_EQ(run.wait(), kSystem);
  expect_text(run.err(), "cannot write the recording " + recording.string() + ": No space left on device");
  const std::string part = "mrroc-" + std::to_string(run.pid()) + ".part";
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::temp_directory_path() / part)) << "a device is written at once";
}

TEST(WrongInput, UnwritableSnapshotsAreReportedBeforeAnythingStarts) {
  const std::string output = run_mrroc({"run", "tasks/press/press.toml", "--snapshots", "README.md/snapshots"}, kUsage);
  expect_text(output, "README.md/snapshots");
  expect_nothing_started(output);
}

/// Runs a deployment of one irb6 with the files of this project, in which the first `from` in `file` is replaced by
/// `to`.
std::string run_with_changed_robot(const std::string& file, const std::string& from, const std::string& to) {
  const std::filesystem::path share = std::filesystem::path(MRROC_BINARY_DIR) / "share/mrroc";
  const ScratchFolder folder;
  const auto own = folder.path() / "robots/irb6";
  std::filesystem::create_directories(own);
  for (const char* name : {"irb6.toml", "irb6.urdf", "irb6.xml"}) {
    std::filesystem::copy_file(share / "robots/irb6" / name, own / name);
  }
  folder.write("robots/irb6/" + file, changed_file(share / "robots/irb6" / file, from, to));
  setenv("MRROC_SHARE", (folder.path().string() + ":" + share.string()).c_str(), 1);
  const auto deployment = folder.write("arm.toml",
                                       "[deployment]\nname = \"arm\"\n[robots.arm]\ntype = \"irb6\"\n"
                                       "hardware = \"loopback\"\nprogram = \"irb6_demo\"\n");
  const std::string output = run_mrroc({"run", deployment.string()}, kUsage);
  unsetenv("MRROC_SHARE");
  return output;
}

TEST(WrongInput, UrdfOfAnotherMachineIsRefusedWithBothPositions) {
  const std::string output = run_with_changed_robot("irb6.urdf", "xyz=\"0.67 0 0\"", "xyz=\"0.68 0 0\"");
  expect_text(output, "process arm_edp died: exit code 2: ");
  expect_text(output, "robots/irb6/irb6.urdf:");
  expect_text(output, ": link 'flange': is at (");
  expect_text(output, " m, the model has it at (");
  expect_nothing_moved(output);
}

TEST(WrongInput, TransmissionThatReachesItsDeadCentreIsRefused) {
  const std::string output =
      run_with_changed_robot("irb6.toml", "synchro_length = 0.1838348", "synchro_length = 0.1238348");
  expect_text(output, ": geometry.upper_arm_screw.synchro_length: the screw is ");
  expect_nothing_moved(output);
}

TEST(WrongInput, InconsistentParameterFileIsRefused) {
  const std::string output = run_with_changed_robot("irb6.toml", "motor_min = -470.0", "motor_min = -100.0");
  expect_text(output, "process arm_edp died: exit code 2: ");
  expect_text(output, ": axes[0].position_max: 2.87 is out of the motors' reach, expected ");
  expect_nothing_moved(output);
}

TEST(WrongInput, MpThatRequestsAMissingRobotIsRefused) {
  const ScratchFolder folder;
  const auto file = folder.write("names.toml",
                                 "[deployment]\nname = \"names\"\n[mp]\nprogram = \"press_mp\"\n"
                                 "[robots.other]\ntype = \"irb6\"\nhardware = \"loopback\"\n");
  const std::string output = run_mrroc({"run", file.string()}, kTaskFailed);
  expect_text(output, "process mp died: exit code 1: ");
  expect_text(output, "the deployment has no robot 'arm', it has: other");
  expect_nothing_moved(output);
}

TEST(WrongInput, EcpThatRequestsAMissingSensorIsRefused) {
  const ScratchFolder folder;
  const auto file = folder.write("sensors.toml",
                                 "[deployment]\nname = \"sensors\"\n[robots.arm]\ntype = \"irb6\"\nhardware = "
                                 "\"loopback\"\nprogram = \"press_ecp\"\n");
  const std::string output = run_mrroc({"run", file.string()}, kTaskFailed);
  expect_text(output, "process arm died: exit code 1: ");
  expect_text(output, "the deployment has no sensor 'wrist', it has: none");
  expect_nothing_moved(output);
}

}  // namespace
}  // namespace mrroc::test::wrong_input_test
