#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "kinematics/chain_model.hpp"

namespace mrroc::cli {

/// An installed robot type that is a chain of joints, with its files.
struct ChainType {
  std::filesystem::path parameters, urdf, mjcf, scene;  ///< NAME.toml, NAME.urdf, NAME.xml, demo.xml
  std::string base, tip;                                ///< links of the URDF
  std::shared_ptr<const kinematics::ChainModel> model;
};

/// Reads it from the folders in which a run searches types. Throws config::ConfigurationError: no such type, with those
/// that exist; a type without a table `[chain]`; what load_arm refuses. Configuration time only.
ChainType load_chain_type(const std::string& name);

}  // namespace mrroc::cli
