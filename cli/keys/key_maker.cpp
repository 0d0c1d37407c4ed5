#include "cli/keys/key_maker.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "cli/keys/certificates.hpp"
#include "links/transport/security.hpp"

namespace mrroc::cli {

namespace {

namespace fs = std::filesystem;
using links::KeyFiles;

constexpr const char* kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<dds xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">\n";
constexpr const char* kAllDomains = "<domains><id_range><min>0</min><max>230</max></id_range></domains>\n";

/// Participants without an identity are ignored; each process signs every message except those of the handshake itself.
std::string governance() {
  return std::string{kHead} + "<domain_access_rules><domain_rule>\n" + kAllDomains +
         R"(<allow_unauthenticated_participants>false</allow_unauthenticated_participants>
<enable_join_access_control>true</enable_join_access_control>
<discovery_protection_kind>SIGN</discovery_protection_kind>
<liveliness_protection_kind>SIGN</liveliness_protection_kind>
<rtps_protection_kind>SIGN</rtps_protection_kind>
<topic_access_rules><topic_rule>
<topic_expression>*</topic_expression>
<enable_discovery_protection>true</enable_discovery_protection>
<enable_liveliness_protection>true</enable_liveliness_protection>
<enable_read_access_control>true</enable_read_access_control>
<enable_write_access_control>true</enable_write_access_control>
<metadata_protection_kind>NONE</metadata_protection_kind>
<data_protection_kind>NONE</data_protection_kind>
</topic_rule></topic_access_rules>
</domain_rule></domain_access_rules>
</dds>
)";
}

std::string permissions(const std::string& subject, const std::string& topics) {
  const std::string rule = "<topics><topic>" + topics + "</topic></topics>";
  return std::string{kHead} + "<permissions><grant name=\"deployment\">\n<subject_name>CN=" + subject +
         "</subject_name>\n<validity><not_before>2000-01-01T00:00:00Z</not_before>"
         "<not_after>2099-12-31T00:00:00Z</not_after></validity>\n<allow_rule>\n" +
         kAllDomains + "<publish>" + rule + "</publish>\n<subscribe>" + rule +
         "</subscribe>\n</allow_rule>\n<default>DENY</default>\n</grant></permissions>\n</dds>\n";
}

[[noreturn]] void refuse(const fs::path& path) {
  throw std::runtime_error("keys: " + path.string() + " cannot be made: " + std::strerror(errno));
}

void write(const fs::path& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0) refuse(path);
  int problem = 0;
  for (std::size_t done = 0; problem == 0 && done < text.size();) {
    const ssize_t size = ::write(file, text.data() + done, text.size() - done);
    if (size < 0 && errno != EINTR) problem = errno;
    done += static_cast<std::size_t>(std::max<ssize_t>(size, 0));
  }
  if (::close(file) != 0 && problem == 0) problem = errno;
  errno = problem;
  if (problem != 0) refuse(path);
}

void fill(const fs::path& folder, const std::string& deployment) {
  const std::string subject = deployment.empty() ? "mrroc" : deployment;
  const PrivateKey authority_key = new_private_key();
  const Certificate authority =
      certify(subject + " authority", authority_key.get(), CertificateUse::authority, nullptr, authority_key.get());
  const PrivateKey key = new_private_key();
  const Certificate identity =
      certify(subject, key.get(), CertificateUse::identity, authority.get(), authority_key.get());
  const auto sign = [&](const std::string& text) { return sign_document(text, authority.get(), authority_key.get()); };
  write(folder / KeyFiles::authority, to_pem(authority.get()));
  write(folder / KeyFiles::identity, to_pem(identity.get()));
  write(folder / KeyFiles::identity_key, to_pem(key.get()));
  write(folder / KeyFiles::governance, sign(governance()));
  write(folder / KeyFiles::permissions, sign(permissions(subject, deployment.empty() ? "*" : deployment + "/*")));
}

}  // namespace

void make_keys(const fs::path& folder, const std::string& deployment) {
  if (::mkdir(folder.c_str(), S_IRWXU) != 0) {
    if (errno != EEXIST) refuse(folder);
    throw std::runtime_error("keys: " + folder.string() +
                             " is there already and keys are never overwritten: remove it, or name another folder");
  }
  try {
    fill(folder, deployment);
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  }
}

}  // namespace mrroc::cli
