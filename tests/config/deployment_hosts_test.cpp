// A deployment over more than one machine: its network, and the machine of each process.
#include <unistd.h>

#include "config/deployment_fixture.hpp"
#include "config/network/network_entry.hpp"

namespace mrroc::config::deployment_hosts_test {
namespace {

class DeploymentHosts : public DeploymentFixture {
 protected:
  DeploymentHosts() : DeploymentFixture("valid") {}
};

/// A deployment of one loopback robot with `network` as its table [network].
std::string with_network(const std::string& network) {
  return "[deployment]\nname = 'one'\n[robots.arm]\ntype = 'irb6'\nhardware = 'loopback'\n[network]\n" + network;
}

TEST_F(DeploymentHosts, StaysOnThisMachineWithoutKeysWithoutANetwork) {
  for (const char* file : {"minimal.toml", "full.toml"}) {
    const NetworkEntry network = load_deployment(file).network;
    EXPECT_EQ(network.interface, "") << file;
    EXPECT_FALSE(network.security) << file;
    EXPECT_TRUE(network.keys.empty()) << file;
  }
}

TEST_F(DeploymentHosts, SecurityIsOnWithANetworkOrKeys) {
  const task_test::ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() / "cell_keys");
  const auto network = [&](const std::string& text) {
    return load_deployment(scratch.write("d.toml", with_network(text))).network;
  };
  const NetworkEntry open = network("interface = 'eth1'\nkeys = 'cell_keys'\n");
  EXPECT_EQ(open.interface, "eth1");
  EXPECT_TRUE(open.security);
  EXPECT_EQ(open.keys, scratch.path() / "cell_keys");
  EXPECT_TRUE(network("keys = 'cell_keys'\n").security);
  EXPECT_TRUE(network("security = true\nkeys = 'cell_keys'\n").security);
  EXPECT_FALSE(network("security = false\nkeys = 'cell_keys'\n").security);
  EXPECT_FALSE(network("interface = '10.0.0.2'\nsecurity = false\n").security);
  for (const char* loopback : {"lo", "127.0.0.1"}) {
    EXPECT_FALSE(network("interface = '" + std::string{loopback} + "'\n").security) << loopback;
  }
}

TEST_F(DeploymentHosts, RemoteHostNeedsAnInterfaceAndKeys) {
  const task_test::ScratchFolder scratch;
  std::filesystem::create_directory(scratch.path() / "cell_keys");
  const auto problem = [&](const std::string& text) {
    const auto file = scratch.write("d.toml", with_network(text) + "[hosts.cell]\naddress = 'lab-pc-2'\n");
    Deployment deployment;
    deployment.hosts.emplace_back().name = deployment.robots.emplace_back().host = "cell";
    deployment.hosts.front().address = "lab-pc-2";
    return message_of(scratch.path(), [&] { read_network(Table::load(file), deployment); });
  };
  EXPECT_EQ(problem(""),
            "d.toml:7: hosts.cell: 'cell' is another machine, but no interface to reach it by is named, "
            "expected a table [network] with interface = \"DEVICE\"");
  EXPECT_TRUE(problem("interface = 'lo'\n").starts_with("d.toml:8: hosts.cell: 'cell' is another machine, but"));
  EXPECT_EQ(problem("interface = 'eth1'\n"),
            "d.toml:6: network: no keys, but it reaches beyond this machine, expected keys = \"FOLDER\" made by `mrroc "
            "keys FOLDER`, or security = false");
  EXPECT_EQ(problem("interface = 'eth1'\nsecurity = false\n"), "");
  EXPECT_EQ(problem("interface = 'eth1'\nkeys = 'cell_keys'\n"), "");
}

TEST_F(DeploymentHosts, RecognisesThisMachineByAllItsNames) {
  const task_test::ScratchFolder scratch;
  char own_name[256] = "";
  ASSERT_EQ(gethostname(own_name, sizeof own_name - 1), 0);
  for (const auto& host : std::vector<std::string>{"", "localhost", "127.0.0.1", "127.3.2.1", "::1", own_name}) {
    const auto file = scratch.write("d.toml",
                                    "deployment.name = 'one'\nrobots.arm.type = 'irb6'\n"
                                    "robots.arm.hardware = 'loopback'\nrobots.arm.host = '" +
                                        host + "'\n");
    EXPECT_EQ(load_deployment(file).robots[0].host, "") << host;
  }
}

/// An arm with its sensor and the simulated world on host `cell`, a belt on this machine.
std::string on_two_hosts() {
  return "[deployment]\nname = 'two'\nclock = 'real'\nservo_period = 0.004\n"
         "[network]\ninterface = 'eth1'\nsecurity = false\n"
         "[hosts.cell]\naddress = 'pc-2.lab'\n"
         "[hosts.other]\naddress = '10.0.0.3'\ncommand = ['ssh', '-p', '22', 'x']\nmrroc = '/opt/bin/mrroc'\nfolder = "
         "'/t'\n"
         "[robots.arm]\ntype = 'irb6'\nhardware = 'mujoco'\nhost = 'cell'\n"
         "[robots.belt]\ntype = 'conveyor'\nhardware = 'loopback'\n"
         "[sensors.wrist]\ntype = 'force_torque'\nrobot = 'arm'\n"
         "[sensors.gate]\ntype = 'ultrasonic'\nmount = [0, 0, 1]\n"
         "[sim]\nscene = 'scene.xml'\n";
}

TEST_F(DeploymentHosts, ReadsHosts) {
  const task_test::ScratchFolder scratch;
  scratch.write("scene.xml", "");
  const Deployment deployment = load_deployment(scratch.write("d.toml", on_two_hosts()));
  ASSERT_EQ(deployment.hosts.size(), 2u);
  EXPECT_EQ(deployment.hosts[0].name, "cell");
  EXPECT_EQ(deployment.hosts[0].address, "pc-2.lab");
  EXPECT_TRUE(deployment.hosts[0].command.empty());
  EXPECT_EQ(deployment.hosts[0].mrroc, "");
  EXPECT_EQ(deployment.hosts[0].folder, "");
  EXPECT_EQ(deployment.hosts[1].command, (std::vector<std::string>{"ssh", "-p", "22", "x"}));
  EXPECT_EQ(deployment.hosts[1].mrroc, "/opt/bin/mrroc");
  EXPECT_EQ(deployment.hosts[1].folder, "/t");
  EXPECT_EQ(deployment.link_timeout, 0.04);
  EXPECT_EQ(deployment.clock_error, 0.002) << "half a servo period";
  ASSERT_EQ(deployment.hosts_used().size(), 1u);
  EXPECT_EQ(deployment.hosts_used()[0], &deployment.hosts[0]);
}

TEST_F(DeploymentHosts, WorldAndSensorsRunWithTheirRobots) {
  const task_test::ScratchFolder scratch;
  scratch.write("scene.xml", "");
  const Deployment deployment = load_deployment(scratch.write("d.toml", on_two_hosts()));
  EXPECT_EQ(deployment.robot("arm").host, "cell");
  EXPECT_EQ(deployment.robot("belt").host, "");
  EXPECT_EQ(deployment.sensor("wrist").host, "cell");
  EXPECT_EQ(deployment.sensor("gate").host, "cell") << "it measures in the simulated world";
  EXPECT_EQ(deployment.sim->host, "cell");
}

TEST_F(DeploymentHosts, SearchesProgramsOnTheirHost) {
  const task_test::ScratchFolder scratch;
  scratch.write("scene.xml", "");
  const auto file = scratch.write("d.toml", on_two_hosts());
  const Deployment here = load_deployment(file);
  EXPECT_EQ(here.mp.program, program("mrroc_mp"));
  EXPECT_EQ(here.robot("arm").edp_program, "irb6_edp");
  EXPECT_EQ(here.robot("belt").edp_program, program("conveyor_edp"));
  EXPECT_EQ(here.sensor("wrist").vsp_program, "force_torque_vsp");
  EXPECT_EQ(here.sim->program, "mrroc_sim");
  hand_down_host("cell");
  const Deployment there = load_deployment(file);
  unsetenv("MRROC_HOST");
  EXPECT_EQ(there.here, "cell");
  EXPECT_EQ(there.mp.program, "mrroc_mp");
  EXPECT_EQ(there.robot("arm").program, program("mrroc_ecp"));
  EXPECT_EQ(there.robot("arm").edp_program, program("irb6_edp"));
  EXPECT_EQ(there.robot("belt").edp_program, "conveyor_edp");
  EXPECT_EQ(there.sensor("gate").vsp_program, program("ultrasonic_vsp"));
  EXPECT_EQ(there.sim->program, program("mrroc_sim"));
}

}  // namespace
}  // namespace mrroc::config::deployment_hosts_test
