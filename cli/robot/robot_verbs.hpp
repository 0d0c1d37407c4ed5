#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace mrroc::cli {

/// The arguments of `mrroc robot add`.
struct AddRequest {
  std::filesystem::path urdf;
  std::string name;              ///< of the type; empty: the robot's name in the URDF
  std::string base, tip;         ///< links; empty: as arm_of
  std::filesystem::path limits;  ///< empty: no file
  bool accept_guesses = false;
  std::string drives = "itself";  ///< what moves the arm: "itself" or "torque"
  std::filesystem::path into;     ///< empty: the user's folder of robots
  bool replace = false;           ///< an existing folder of the type
  std::optional<double> reach;    ///< m, from the base to the tip: compared with that of the URDF
};

/// The arguments of `mrroc robot show`.
struct ShowRequest {
  std::string arm;                ///< the name of a type, or a URDF
  std::string base, tip;          ///< of a URDF
  int postures = 2000;            ///< of the workspace
  std::filesystem::path picture;  ///< PNG file to write; empty: none
};

/// The arguments of `mrroc robot check`.
struct CheckRequest {
  std::string type;
  int postures = 10000;
};

/// What the verbs do, with the description of the verb, for its words.
struct RobotActions {
  std::function<void(const CLI::App&, const AddRequest&)> add;
  std::function<void(const CLI::App&, const ShowRequest&)> show;
  std::function<void(const CLI::App&, const CheckRequest&)> check;
};

/// Adds the verbs `add`, `show` and `check` to `robot`; a parsed verb calls its action.
void add_robot_verbs(CLI::App& robot, const RobotActions& actions);

}  // namespace mrroc::cli
