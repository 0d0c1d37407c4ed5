#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mrroc::links {

/// The files of a deployment's keys, in one folder made by `mrroc keys FOLDER`.
struct KeyFiles {
  static constexpr const char* authority = "authority.pem";        ///< certificate that has signed all the others
  static constexpr const char* identity = "identity.pem";          ///< certificate of the deployment's processes
  static constexpr const char* identity_key = "identity_key.pem";  ///< its private key
  static constexpr const char* governance = "governance.p7s";      ///< the protection settings, signed
  static constexpr const char* permissions = "permissions.p7s";    ///< the topics that the identity may use, signed
};

/// Throws SystemError (configuration), with what to do, unless `folder` holds all files of KeyFiles and only their
/// owner may read or change them.
void check_keys(const std::filesystem::path& folder);

/// The participant's properties that switch DDS Security on with the keys of `folder`, after `check_keys`. Throws
/// SystemError (resources) where Cyclone's security plug-ins are not installed.
std::map<std::string, std::string> security_properties(const std::filesystem::path& folder);

}  // namespace mrroc::links
