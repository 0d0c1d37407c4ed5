#include "cli/operator/socket/socket_folder.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace mrroc::cli {

namespace {

constexpr int kBacklog = 16;
constexpr const char* kExtension = ".sock";

std::optional<std::filesystem::path> runtime_folder() {
  const char* const folder = std::getenv("XDG_RUNTIME_DIR");
  if (folder == nullptr || folder[0] != '/') return std::nullopt;
  struct stat status {};
  if (stat(folder, &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != geteuid()) return std::nullopt;
  return std::filesystem::path(folder) / "mrroc";
}

/// The folder that the user names, instead of the others.
std::optional<std::filesystem::path> named_folder() {
  const char* const folder = std::getenv("MRROC_RUNTIME_DIR");
  if (folder == nullptr || folder[0] == '\0') return std::nullopt;
  return std::filesystem::absolute(folder);
}

/// This user's number outside a user namespace: inside one, many users are 0, and all share /tmp.
std::uint64_t user_outside() {
  const std::uint64_t user = geteuid();
  std::ifstream ranges("/proc/self/uid_map");
  for (std::uint64_t inside, outside, count; ranges >> inside >> outside >> count;)
    if (user >= inside && user - inside < count) return outside + (user - inside);
  return user;
}

std::filesystem::path temporary_folder() { return "/tmp/mrroc-" + std::to_string(user_outside()); }

/// Empty when only this user may enter the folder.
std::string fault_of(const std::filesystem::path& folder) {
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0) return std::strerror(errno);
  if (!S_ISDIR(status.st_mode)) return "is not a folder";
  if (status.st_uid != geteuid()) return "belongs to user " + std::to_string(status.st_uid);
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) return "may be entered by other users, expected mode 0700";
  return "";
}

/// An address of a path of any length: the folder is named by a descriptor, which this object closes.
class Address {
 public:
  explicit Address(const std::filesystem::path& path)
      : folder_(open(path.parent_path().c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
    address_.sun_family = AF_UNIX;
    const int length = std::snprintf(address_.sun_path, sizeof address_.sun_path, "/proc/self/fd/%d/%s", folder_,
                                     path.filename().c_str());
    fits_ = length > 0 && static_cast<std::size_t>(length) < sizeof address_.sun_path;
  }
  ~Address() {
    if (folder_ >= 0) close(folder_);
  }
  Address(const Address&) = delete;
  Address& operator=(const Address&) = delete;

  bool valid() const noexcept { return folder_ >= 0 && fits_; }
  const sockaddr* get() const noexcept { return reinterpret_cast<const sockaddr*>(&address_); }

 private:
  int folder_;
  bool fits_ = false;
  sockaddr_un address_{};
};

void add_sockets(const std::filesystem::path& folder, std::vector<std::filesystem::path>& found) {
  if (!fault_of(folder).empty()) return;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != kExtension) continue;
    const int fd = connect_to(entry.path());
    if (fd < 0 && errno == ECONNREFUSED) unlink(entry.path().c_str());
    if (fd < 0) continue;
    close(fd);
    found.push_back(entry.path());
  }
}

}  // namespace

std::filesystem::path make_socket_folder() {
  std::filesystem::path folder = named_folder().value_or(runtime_folder().value_or(temporary_folder()));
  if (mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST)
    throw std::runtime_error("cannot create " + folder.string() + ": " + std::strerror(errno));
  if (const std::string fault = fault_of(folder); !fault.empty())
    throw std::runtime_error("the folder " + folder.string() + " " + fault);
  return folder;
}

std::vector<std::filesystem::path> operator_sockets() {
  std::vector<std::filesystem::path> found;
  if (const auto folder = named_folder()) {
    add_sockets(*folder, found);
  } else {
    if (const auto runtime = runtime_folder()) add_sockets(*runtime, found);
    add_sockets(temporary_folder(), found);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.filename() < b.filename(); });
  return found;
}

int listen_at(const std::filesystem::path& path) {
  // it gets its name when it listens: clients take a socket that refuses them for that of a dead run, and remove it
  const std::filesystem::path unfinished = path.string() + ".new";
  unlink(unfinished.c_str());
  const Address address(unfinished);
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const auto fail = [&path, fd](const char* reason) {
    if (fd >= 0) close(fd);
    throw std::runtime_error("the operator socket " + path.string() + ": " + reason);
  };
  if (fd < 0) fail(std::strerror(errno));
  if (!address.valid()) fail("has no valid path");
  // the mode must hold from the first moment: it is set before the file exists
  if (fchmod(fd, S_IRUSR | S_IWUSR) != 0) fail(std::strerror(errno));
  if (bind(fd, address.get(), sizeof(sockaddr_un)) != 0) fail(std::strerror(errno));
  if (listen(fd, kBacklog) != 0 || rename(unfinished.c_str(), path.c_str()) != 0) {
    const int problem = errno;
    unlink(unfinished.c_str());
    fail(std::strerror(problem));
  }
  return fd;
}

int connect_to(const std::filesystem::path& path) noexcept {
  const Address address(path);
  if (!address.valid()) return -1;
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fd < 0 || connect(fd, address.get(), sizeof(sockaddr_un)) == 0) return fd;
  const int problem = errno;
  close(fd);
  errno = problem;
  return -1;
}

}  // namespace mrroc::cli
