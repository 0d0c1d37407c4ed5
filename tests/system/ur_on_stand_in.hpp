#pragma once

#include <filesystem>
#include <random>
#include <string>

#include "free_port.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "replace.hpp"
#include "text_of.hpp"

namespace mrroc::test {

/// An address of loopback that no other test has.
inline std::string loopback_address() {
  std::random_device random;
  std::string address = "127";
  for (int i = 0; i < 3; ++i) address += "." + std::to_string(2 + random() % 248);
  return address;
}

/// `deployment` of one irb6 in the simulated world, with the arm behind the stand-in of a UR controller, and with these
/// lines in its table. Files are in `folder`.
inline std::string on_ur_stand_in(std::string deployment, const task_test::ScratchFolder& folder,
                                  const std::string& more = "") {
  const std::filesystem::path source = MRROC_SOURCE_DIR;
  const auto arm =
      folder.write("arm.toml", "drives = { regulates = \"itself\", interface = \"position\", bandwidth = 20.0 }\n" +
                                   text_of(source / "robots/irb6/irb6.toml"));
  replace(deployment, "hardware = \"mujoco\"",
          "parameters = \"" + arm.string() + "\"\nhardware = \"ur\"\nur = { address = \"" + loopback_address() +
              "\", simulated = true, rtde_port = " + free_port() + ", dashboard_port = " + free_port() +
              ", script_port = " + free_port() + more + " }");
  return deployment;
}

/// The task press on the stand-in, with these lines in the table of its wrist.
inline std::string press_on_ur_stand_in(const task_test::ScratchFolder& folder, const std::string& wrist) {
  const std::filesystem::path press = std::filesystem::path(MRROC_SOURCE_DIR) / "tasks/press";
  std::string text = text_of(press / "press.toml");
  replace(text, "\"press.xml\"", "\"" + (press / "press.xml").string() + "\"");
  replace(text, "[sensors.wrist]\n", "[sensors.wrist]\n" + wrist + "\n");
  return on_ur_stand_in(text, folder);
}

/// Lines of a sensor's table for the stand-in of a Net F/T.
inline std::string netft_stand_in() {
  return "source = \"netft\"\nnetft = { address = \"" + loopback_address() +
         "\", simulated = true, port = " + free_port(SOCK_DGRAM) + ", http_port = " + free_port() + " }";
}

}  // namespace mrroc::test
