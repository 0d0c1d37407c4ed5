#include "system/hosts/two_hosts.hpp"

#include <algorithm>

#include "privileges.hpp"

namespace mrroc::test {

namespace {

std::string in_toml(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return "[" + text + "]";
}

/// Before the first test, while there is one thread.
struct Root : testing::Environment {
  void SetUp() override { enter_own_network(); }
};
[[maybe_unused]] const testing::Environment* const root_of_namespace = testing::AddGlobalTestEnvironment(new Root);

}  // namespace

void TwoHosts::SetUp() {
  cable_.emplace();
  if (with_keys()) run_mrroc({"keys", file("keys").string()}, 0);
}

std::string TwoHosts::hosts(const std::string& name, const std::string& limits, std::vector<std::string> command,
                            const std::string& more) const {
  if (command.empty()) command = cable_->b().command();
  return "[deployment]\nname = \"" + name + "\"\nclock = \"real\"\n" + limits + "[network]\ninterface = \"cable0\"\n" +
         (with_keys() ? "keys = \"keys\"" : "security = false") +
         "\n"
         "[hosts.cell]\naddress = \"" +
         Cable::kAddressOfB + "\"\ncommand = " + in_toml(command) + "\n" + more;
}

std::string TwoHosts::press() {
  return "[mp]\nprogram = \"press_mp\"\n"
         "[robots.arm]\ntype = \"irb6\"\nhardware = \"mujoco\"\nhost = \"cell\"\nposition = [0.0, 0.0, 0.7]\n"
         "[sensors.wrist]\ntype = \"force_torque\"\nrobot = \"arm\"\n"
         "[sensors.gate]\ntype = \"ultrasonic\"\nmode = \"non-interactive\"\nrate = 50\n"
         "[sim]\nscene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"\n";
}

std::string TwoHosts::hold() {
  return "[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\nhost = \"cell\"\nprogram = \"" MRROC_BINARY_DIR
         "/tests/faulty_ecp\"\n";
}

std::string TwoHosts::to_and_fro() {
  return "[robots.arm]\ntype = \"irb6\"\nhardware = \"mujoco\"\nhost = \"cell\"\nposition = [0.0, 0.0, 0.7]\n"
         "program = \"" MRROC_BINARY_DIR
         "/tests/emergency_stop_ecp\"\n"
         "[sim]\nscene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"\n";
}

MrrocRun& TwoHosts::start(const std::filesystem::path& deployment, const std::vector<std::string>& options) {
  std::vector<std::string> arguments{"run", deployment.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Inside inside(cable_->a());
  return run_.emplace(arguments);
}

MrrocRun& TwoHosts::start_until(const std::string& printed, const std::filesystem::path& deployment,
                                const std::vector<std::string>& options) {
  for (int more = with_keys() ? 2 : 0; !start(deployment, options).wait_for_output(printed); --more) {
    if (more > 0 && output().find("not ready within") != std::string::npos) continue;
    ADD_FAILURE() << "'" << printed << "' is not printed: " << output();
    break;
  }
  return *run_;
}

void TwoHosts::expect_end(int code, const std::vector<std::string>& causes, const std::vector<pid_t>& pids) {
  EXPECT_EQ(run_->wait(), code) << output();
  const auto reported = [this](const std::string& cause) { return run_->err().find(cause) != std::string::npos; };
  EXPECT_TRUE(std::any_of(causes.begin(), causes.end(), reported)) << output();
  EXPECT_TRUE(all_end(pids)) << output();
}

}  // namespace mrroc::test
