#include "links/transport/security.hpp"

#include <dds/dds.h>
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include "links/cyclone/authentication.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kOthers = S_IRWXG | S_IRWXO;

[[noreturn]] void refuse(const fs::path& path, const std::string& problem, const std::string& expected) {
  throw SystemError(ErrorCode::configuration, "keys " + path.string() + ": " + problem + ", expected " + expected);
}

void check_file(const fs::path& folder, const char* name) {
  const fs::path path = folder / name;
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
    refuse(path, "there is no such file", "a folder made by `mrroc keys " + folder.string() + "`");
  }
  if ((status.st_mode & kOthers) != 0) refuse(path, "open to other users", "`chmod 600 " + path.string() + "`");
  if (::access(path.c_str(), R_OK) != 0) refuse(path, "cannot be read", "a file of the user who runs the deployment");
}

/// The folder of Cyclone's security plug-ins: in Debian a folder beside the library, in Cyclone's own installation that
/// of the library.
fs::path plugins() {
  Dl_info library{};
  // not through the function's name: its address may be a stub in this program
  void* address = ::dlsym(RTLD_DEFAULT, "dds_create_domain");
  if (address == nullptr || ::dladdr(address, &library) == 0) {
    throw SystemError(ErrorCode::resources, "DDS security: Cyclone DDS is not a shared library here");
  }
  const fs::path beside = fs::canonical(library.dli_fname).parent_path();
  for (const fs::path& folder : {beside / "libddsc0debian", beside}) {
    if (fs::exists(folder / "libdds_security_auth.so")) return folder;
  }
  throw SystemError(ErrorCode::resources, "DDS security: no libdds_security_auth.so in " +
                                              (beside / "libddsc0debian").string() + " nor " + beside.string());
}

}  // namespace

void check_keys(const fs::path& folder) {
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
    refuse(folder, "there is no such folder", "one made by `mrroc keys " + folder.string() + "`");
  }
  if ((status.st_mode & kOthers) != 0) refuse(folder, "open to other users", "`chmod 700 " + folder.string() + "`");
  for (const char* name :
       {KeyFiles::authority, KeyFiles::identity, KeyFiles::identity_key, KeyFiles::governance, KeyFiles::permissions}) {
    check_file(folder, name);
  }
}

std::map<std::string, std::string> security_properties(const fs::path& folder) {
  check_keys(folder);
  const auto file = [&folder](const char* name) { return "file:" + fs::absolute(folder / name).string(); };
  std::map<std::string, std::string> properties{
      {"dds.sec.auth.identity_ca", file(KeyFiles::authority)},
      {"dds.sec.auth.identity_certificate", file(KeyFiles::identity)},
      {"dds.sec.auth.private_key", file(KeyFiles::identity_key)},
      {"dds.sec.access.permissions_ca", file(KeyFiles::authority)},
      {"dds.sec.access.governance", file(KeyFiles::governance)},
      {"dds.sec.access.permissions", file(KeyFiles::permissions)},
  };
  const fs::path folder_of_plugins = plugins();
  const auto plugin = [&](const std::string& service, const std::string& library, const std::string& functions) {
    const std::string prefix = "dds.sec." + service + ".library.";
    properties[prefix + "path"] = (folder_of_plugins / ("libdds_security_" + library + ".so")).string();
    properties[prefix + "init"] = "init_" + functions;
    properties[prefix + "finalize"] = "finalize_" + functions;
  };
  const AuthenticationLibrary authentication = authentication_library(folder_of_plugins / "libdds_security_auth.so");
  properties["dds.sec.auth.library.path"] = authentication.path;
  properties["dds.sec.auth.library.init"] = authentication.init;
  properties["dds.sec.auth.library.finalize"] = authentication.finalize;
  plugin("access", "ac", "access_control");
  plugin("crypto", "crypto", "crypto");
  return properties;
}

}  // namespace mrroc::links
