#pragma once

#include <filesystem>
#include <functional>

#include "config/robot_files.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// Loads a robot's models from its parameter file; an empty path is the installed file of its type. An EDP that serves
/// several types gets the path of every file.
using ModelFactory = std::function<RobotModels(const std::filesystem::path& parameters)>;

/// main() of an EDP: the process that owns one robot. It checks the robot's files (robot_check.hpp), opens the hardware
/// that the deployment names, passes the start-up barrier, switches the drives on, and from then on executes the
/// commands of its ECP. Under simulated time its participant runs the servo tick; in real time its own thread
/// does; when it is asked to end there, it stops the robot within its limits and switches the drives off.
/// With `limits` or `workspace` as its first argument it prints data of its robot instead (describe.hpp).
int run(int argc, char** argv, const ModelFactory& factory);

}  // namespace mrroc::edp

/// Makes an EDP out of a function that loads a robot's models: of a given parameter file (`load_models(file)`), or of
/// the type's own only.
#define MRROC_EDP(load_models)                                      \
  int main(int argc, char** argv) {                                 \
    return mrroc::edp::run(argc, argv, [](const auto& parameters) { \
      if constexpr (requires { load_models(parameters); }) {        \
        return load_models(parameters);                             \
      } else {                                                      \
        mrroc::config::refuse_parameters(parameters);               \
        return load_models();                                       \
      }                                                             \
    });                                                             \
  }
