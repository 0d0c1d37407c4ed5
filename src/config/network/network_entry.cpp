#include "config/network/network_entry.hpp"

#include <algorithm>

#include "config/entries/named_file.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr const char* kMakeKeys = "keys = \"FOLDER\" made by `mrroc keys FOLDER`, or security = false";

/// The first host that is another machine, or null. A host at a loopback address is this machine.
const HostEntry* first_remote(const Deployment& deployment) {
  const auto used = deployment.hosts_used();
  const auto remote = std::find_if(used.begin(), used.end(), [](const HostEntry* host) {
    return beyond_loopback(host->address) && host->address != "localhost";
  });
  return remote == used.end() ? nullptr : *remote;
}

std::filesystem::path read_keys(const Table& table) {
  const std::string name = table.text("keys");
  std::filesystem::path folder = beside(table.file(), name);
  if (!std::filesystem::is_directory(folder)) {
    table.fail("keys", in_quotes(name) + " is not a folder", "one made by `mrroc keys " + folder.string() + "`");
  }
  return folder;
}

}  // namespace

std::string read_interface(const Table& table) {
  std::string interface = table.text("interface");
  const auto allowed = [](char c) { return c > ' ' && c < 127 && c != '"' && c != '<' && c != '&' && c != '/'; };
  if (interface.empty() || !std::all_of(interface.begin(), interface.end(), allowed)) {
    table.fail("interface", in_quotes(interface), "a network device (eth1) or an own address (10.0.0.2)");
  }
  return interface;
}

bool beyond_loopback(const std::string& interface) {
  return !interface.empty() && interface != "lo" && !interface.starts_with("127.");
}

NetworkEntry read_network(const Table& root, const Deployment& deployment) {
  NetworkEntry network;
  const HostEntry* remote = first_remote(deployment);
  const auto table = root.optional_table("network");
  if (table) {
    table->only({"interface", "keys", "security"});
    if (table->has("interface")) network.interface = read_interface(*table);
    if (table->has("keys")) network.keys = read_keys(*table);
  }
  if (remote != nullptr && !beyond_loopback(network.interface)) {
    root.table("hosts")
        .table(remote->name)
        .fail("", in_quotes(remote->name) + " is another machine, but no interface to reach it by is named",
              "a table [network] with interface = \"DEVICE\"");
  }
  const bool wanted = remote != nullptr || beyond_loopback(network.interface) || !network.keys.empty();
  network.security = table ? table->boolean_or("security", wanted) : wanted;
  if (network.security && network.keys.empty()) {
    const bool asked = table->has("security");
    table->fail(asked ? "security" : "",
                asked ? "true, but no keys are named" : "no keys, but it reaches beyond this machine",
                asked ? "keys = \"FOLDER\" beside it, made by `mrroc keys FOLDER`" : kMakeKeys);
  }
  return network;
}

}  // namespace mrroc::config
