#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include "system/hosts/cable.hpp"
#include "system/hosts/two_hosts.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::two_hosts_ssh_test {
namespace {

void sh(const std::string& line) {
  if (std::system(line.c_str()) != 0) throw std::runtime_error(line);
}

/// The option of sshd that gives a login the options of the sanitizers, which it does not inherit; "" without any.
std::string sanitizer_options() {
  std::string options;
  for (const char* name : {"ASAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS"}) {
    const char* value = std::getenv(name);
    if (value == nullptr) continue;
    options.append(options.empty() ? "-o 'SetEnv=" : " ").append(name).append("=").append(value);
  }
  if (!options.empty()) options.append("' ");
  return options;
}

/// A real sshd in host b of the cable, with its own keys and one user, its own one: it has no root privileges. Its /run
/// and its /etc/passwd are separate, too.
class SshServer {
 public:
  SshServer(const Cable& cable, const std::filesystem::path& folder) {
    const std::string path = folder.string();
    sh("ssh-keygen -q -t ed25519 -N '' -f " + path + "/host_key && ssh-keygen -q -t ed25519 -N '' -f " + path +
       "/user_key && cp " + path + "/user_key.pub " + path + "/authorized_keys");
    sh("printf '" + std::string{Cable::kAddressOfB} + " ' | cat - " + path + "/host_key.pub > " + path +
       "/known_hosts");
    std::ofstream(folder / "ssh_config") << "IdentityFile " << path << "/user_key\nIdentitiesOnly yes\n"
                                         << "UserKnownHostsFile " << path << "/known_hosts\nUser lab\n";
    sh("(cat /etc/passwd; echo lab:x:1000:1000::" + path + ":/bin/sh) > " + path + "/passwd");
    // the ssh that `mrroc run` finds: the real one, with the location of this test's keys
    std::filesystem::create_directory(folder / "bin");
    std::ofstream(folder / "bin" / "ssh") << "#!/bin/sh\nexec /usr/bin/ssh -F " << path << "/ssh_config \"$@\"\n";
    std::filesystem::permissions(folder / "bin" / "ssh", std::filesystem::perms::owner_all);
    const std::string server =
        "mount -t tmpfs tmpfs /run && mkdir /run/sshd && mount --bind " + path +
        "/passwd /etc/passwd && exec unshare --user --map-user=1000 --map-group=1000 -- /usr/sbin/sshd -D -e " +
        sanitizer_options() + "-f /dev/null -h " + path + "/host_key -o AuthorizedKeysFile=" + path +
        "/authorized_keys -o StrictModes=no -o PidFile=none 2> " + path + "/sshd.log";
    const Inside inside(cable.b());
    std::ofstream("/proc/sys/net/ipv4/ip_unprivileged_port_start") << 0;
    pid_ = fork();
    if (pid_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      // in a separate process namespace: a login behind a cut cable would stay for hours
      execl("/usr/bin/unshare", "unshare", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc", "--", "sh",
            "-c", server.c_str(), nullptr);
      _exit(127);
    }
  }
  ~SshServer() {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  SshServer(const SshServer&) = delete;
  SshServer& operator=(const SshServer&) = delete;

 private:
  pid_t pid_ = -1;
};

bool is_agent(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/cmdline", std::ios::binary);
  const std::string line{std::istreambuf_iterator<char>(file), {}};
  return line.ends_with(std::string("mrroc\0agent\0", 12));
}

/// The default of `command`: ssh.
class TwoHostsOverSsh : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(std::filesystem::exists("/usr/sbin/sshd")) << "scripts/install_dependencies installs openssh-server";
    cable_.emplace();
    server_.emplace(*cable_, folder_.path());
    const std::string path = std::getenv("PATH");
    setenv("PATH", ((folder_.path() / "bin").string() + ":" + path).c_str(), 1);
    await_server();
  }

  /// Waits until a login is possible.
  void await_server() const {
    const Inside inside(cable_->a());
    const std::string login = "ssh -o BatchMode=yes " + std::string{Cable::kAddressOfB} + " true 2> /dev/null";
    for (int look = 0; look < 200 && std::system(login.c_str()) != 0; ++look)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }

  MrrocRun& start(const std::string& address, const std::string& network = "security = false") {
    const auto file = folder_.write("hold.toml",
                                    "[deployment]\nname = \"hold\"\nclock = \"real\"\nlink_timeout = 2\n"
                                    "[network]\ninterface = \"cable0\"\n" +
                                        network +
                                        "\n"
                                        "[hosts.cell]\naddress = \"" +
                                        address +
                                        "\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\nhost = \"cell\"\n"
                                        "program = \"" MRROC_BINARY_DIR "/tests/faulty_ecp\"\n");
    const Inside inside(cable_->a());
    return run_.emplace(std::vector<std::string>{"run", file.string()});
  }

  /// Every process on either host that belongs to this test's deployment.
  std::vector<pid_t> processes() const {
    std::vector<pid_t> pids = run_->descendants();
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string name = entry.path().filename();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      std::ifstream file(entry.path() / "cmdline", std::ios::binary);
      const std::string line{std::istreambuf_iterator<char>(file), {}};
      if (line.find((folder_.path() / "hold.toml").string()) == std::string::npos) continue;
      const pid_t pid = std::stoi(name);
      if (pid == run_->pid()) continue;
      pids.push_back(pid);
      if (line.find("arm_edp") != std::string::npos) pids.push_back(parent_of(pid));  // the agent
    }
    return pids;
  }

  std::string output() const { return run_->out() + run_->err(); }

  ScratchFolder folder_;
  std::optional<Cable> cable_;
  std::optional<SshServer> server_;
  std::optional<MrrocRun> run_;
};

TEST_F(TwoHostsOverSsh, RunAndAreStoppedByTheOperator) {
  run_mrroc({"keys", (folder_.path() / "keys").string()}, 0);
  MrrocRun& run = start(Cable::kAddressOfB, "keys = \"keys\"");
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = processes();
  EXPECT_GE(pids.size(), 5U);  // ssh, mp; the agent, arm, arm_edp
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 5) << output();
  EXPECT_TRUE(all_end(pids)) << output();
}

TEST_F(TwoHostsOverSsh, LeaveNothingWhenTheCableWithTheControlChannelIsCut) {
  MrrocRun& run = start(Cable::kAddressOfB);
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = processes();
  cable_->set({.cut = true});
  EXPECT_EQ(run.wait(), kSystem) << output();
  EXPECT_NE(run.err().find("host cell: link lost: nothing received for 2 s"), std::string::npos) << output();
  EXPECT_TRUE(all_end(pids)) << output();
}

TEST_F(TwoHostsOverSsh, LeaveNothingWhenTheRunnerIsKilled) {
  MrrocRun& run = start(Cable::kAddressOfB);
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = processes();
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_TRUE(all_end(pids)) << output();
}

/// The runner cannot kill it: sshd forwards no signals.
TEST_F(TwoHostsOverSsh, LeaveNoRobotUnderAStoppedAgent) {
  MrrocRun& run = start(Cable::kAddressOfB);
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  std::vector<pid_t> pids = processes();
  const auto agent = std::find_if(pids.begin(), pids.end(), [](pid_t pid) { return is_agent(pid); });
  ASSERT_NE(agent, pids.end());
  const pid_t stopped = *agent;
  pids.erase(agent);
  ASSERT_EQ(kill(stopped, SIGSTOP), 0);
  EXPECT_EQ(run.wait(), kSystem) << output();
  EXPECT_NE(run.err().find("host cell: link lost: nothing received for 2 s"), std::string::npos) << output();
  EXPECT_TRUE(all_end(pids)) << output();
  EXPECT_GE(parent_of(stopped), 0) << "still there: the other processes have ended on their own";
  kill(stopped, SIGKILL);
}

TEST_F(TwoHostsOverSsh, ReportAnUnreachableHost) {
  MrrocRun& run = start("10.77.0.9");
  EXPECT_EQ(run.wait(), kSystem) << output();
  // with ssh's text, which depends on the kernel's timeout
  EXPECT_NE(run.err().find("host cell: no agent could be started: exit code 255: "), std::string::npos) << output();
  EXPECT_TRUE(run.err().find("No route to host") != std::string::npos ||
              run.err().find("ssh: connect to host 10.77.0.9 port 22: ") != std::string::npos)
      << output();
}

}  // namespace
}  // namespace mrroc::test::two_hosts_ssh_test
