#include "config/entries/driver_entry.hpp"

#include <algorithm>
#include <array>

#include "config/clock_names.hpp"
#include "config/entries/declared_keys.hpp"
#include "config/entries/named_file.hpp"
#include "config/resources.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::array<std::string_view, 1> kCommonKeys{"simulated"};

/// What drivers/FOLDER/FOLDER.toml declares.
struct DriverDeclaration {
  std::string folder;
  Table table;

  /// The value of `hardware` or `source` that selects it.
  std::string name() const { return table.optional_text("controller").value_or(folder); }
  /// The name of the sub-table of its keys.
  std::string keys() const { return table.optional_text("table").value_or(name()); }
};

DriverDeclaration read_declaration(const std::string& folder) {
  return {folder, Table::load(type_file("drivers", folder, folder + ".toml"))};
}

/// All drivers of robots, or of sensors.
std::vector<DriverDeclaration> drivers_of(std::string_view of) {
  std::vector<DriverDeclaration> drivers;
  for (const std::string& folder : driver_names()) {
    DriverDeclaration driver = read_declaration(folder);
    if (driver.table.choice("of", {"robot", "sensor"}) == of) drivers.push_back(std::move(driver));
  }
  return drivers;
}

/// The one that is selected by this value of `hardware` or `source`, which is valid.
DriverDeclaration select_driver(std::string_view of, const std::string& name) {
  for (DriverDeclaration& driver : drivers_of(of))
    if (driver.name() == name) return std::move(driver);
  return read_declaration(name);
}

std::vector<ClockMode> read_clocks(const Table& driver, std::string_view key) {
  if (!driver.has(key)) return {ClockMode::real, ClockMode::paced, ClockMode::lockstep};
  std::vector<ClockMode> clocks;
  for (const std::string& name : driver.texts(key)) {
    const auto clock = clock_named(name);
    if (!clock) driver.fail(key, "unknown clock " + in_quotes(name), alternatives(clock_names()));
    clocks.push_back(*clock);
  }
  return clocks;
}

/// A misspelt key, before the missing one that it was to be.
void refuse_unknown_keys(const Table& driver, const Table& own) {
  if (driver.has("stand_in")) own.has("simulated");
  if (const auto parameters = driver.optional_table("parameters"))
    for (const std::string& name : parameters->table_names()) own.has(name);
  own.finish();
}

/// The sub-table of the driver's own keys; without one, an empty table if no key is required.
Table own_table(const DriverDeclaration& declared, const Table& table, std::string_view key,
                const std::string& device) {
  const Table& driver = declared.table;
  const std::string own = declared.keys();
  if (auto found = table.optional_table(own)) return *found;
  std::string place = "a table [";
  place.append(driver.text("of")).append("s.").append(device).append(".").append(own).append("] with its ");
  if (const auto parameters = driver.optional_table("parameters"))
    for (const std::string& name : parameters->table_names())
      if (!parameters->table(name).has("default"))
        table.fail(key, in_quotes(declared.name()) + " needs a table of its own", place + name);
  return Table::parse(driver.file(), "");
}

/// Whether the sensor of this table is inside the controller of its robot, and that controller is simulated.
bool in_simulated_controller(const Table& table, const DriverEntry& driver, const Deployment& deployment) {
  if (driver.controller.empty()) return false;
  const std::string robot = table.optional_text("robot").value_or("");
  return std::any_of(deployment.robots.begin(), deployment.robots.end(), [&](const RobotEntry& each) {
    return each.name == robot && each.driver.name == driver.controller && each.driver.simulated;
  });
}

void read_stand_in(const Table& driver, const Table& own, const Deployment& deployment, const std::string& type,
                   const std::string& host, bool simulated_controller, DriverEntry& entry) {
  const auto program = driver.optional_text("stand_in");
  const std::vector<ClockMode> simulated_clocks = read_clocks(driver, "stand_in_clocks");
  entry.clocks = simulated_controller ? simulated_clocks : read_clocks(driver, "clocks");
  if (!program) return;
  entry.simulated = own.boolean_or("simulated", false);
  if (!entry.simulated) return;
  if (!deployment.sim) own.fail("simulated", "true needs a simulator", "a table [sim]");
  entry.clocks = simulated_clocks;
  entry.stand_in = *program;
  if (const auto place = entry.stand_in.find("{type}"); place != std::string::npos)
    entry.stand_in.replace(place, 6, type);
  if (host == deployment.here) entry.stand_in = require_program(own, "simulated", entry.stand_in);
}

}  // namespace

std::vector<std::string> robot_drivers() {
  std::vector<std::string> names;
  for (const DriverDeclaration& driver : drivers_of("robot")) names.push_back(driver.name());
  return names;
}

std::vector<std::string> sensor_drivers(const std::string& type) {
  std::vector<std::string> names;
  for (const DriverDeclaration& driver : drivers_of("sensor")) {
    const std::vector<std::string> types = driver.table.texts("types");
    if (std::find(types.begin(), types.end(), type) != types.end()) names.push_back(driver.name());
  }
  return names;
}

void allow_driver_tables(const Table& table, std::string_view of, const std::vector<std::string>& drivers) {
  for (const std::string& name : drivers) table.has(select_driver(of, name).keys());
}

bool works_under(const DriverEntry& driver, ClockMode clock) {
  return std::find(driver.clocks.begin(), driver.clocks.end(), clock) != driver.clocks.end();
}

void refuse_driver_tables(const Table& table, std::string_view key, const std::string& name, std::string_view of) {
  for (const DriverDeclaration& other : drivers_of(of)) {
    if (other.name() == name || !table.has(other.keys())) continue;
    table.fail(other.keys(),
               "keys of driver " + in_quotes(other.name()) + " beside " + std::string(key) + " = " + in_quotes(name),
               std::string(key) + " = \"" + other.name() + "\"");
  }
}

DriverEntry read_driver(const Table& table, std::string_view key, const std::string& device, const std::string& type,
                        const std::string& host, const Deployment& deployment) {
  const std::string name = table.text(key);
  const std::string_view of = key == "hardware" ? "robot" : "sensor";
  const DriverDeclaration declared = select_driver(of, name);
  const Table& driver = declared.table;
  driver.only({"of", "types", "world", "clocks", "controller", "stand_in", "stand_in_clocks", "table", "parameters"});
  DriverEntry entry;
  entry.name = declared.folder;
  entry.controller = driver.optional_text("controller").value_or("");
  refuse_driver_tables(table, key, name, of);
  entry.world = driver.boolean_or("world", false);
  if (entry.world && !deployment.sim) table.fail(key, in_quotes(name) + " needs a simulator", "a table [sim]");
  const Table own = own_table(declared, table, key, device);
  refuse_unknown_keys(driver, own);
  read_stand_in(driver, own, deployment, type, host, in_simulated_controller(table, entry, deployment), entry);
  read_declared_keys(driver, own, kCommonKeys, entry);
  // the clock of a controller is judged with its robot
  if (works_under(entry, deployment.clock) || !entry.controller.empty()) return entry;
  const std::vector<ClockMode> of_stand_in = read_clocks(driver, "stand_in_clocks");
  const bool stand_in_would = driver.has("stand_in") && !entry.simulated &&
                              std::find(of_stand_in.begin(), of_stand_in.end(), deployment.clock) != of_stand_in.end();
  own.fail("", "driver " + in_quotes(name) + " does not work under this clock",
           "clock = " + alternatives(driver.texts(entry.simulated ? "stand_in_clocks" : "clocks")) +
               (stand_in_would ? ", or simulated = true" : ""));
}

}  // namespace mrroc::config
