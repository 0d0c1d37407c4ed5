#include "can/hub_listener.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "can/hub_address.hpp"

namespace mrroc::can {

namespace {

/// Allows one process at a time to start a hub in a folder, so that none mistakes a new socket of another for an
/// abandoned one.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : fd_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)),
        held_(fd_ >= 0 && ::flock(fd_, LOCK_EX) == 0) {}
  ~FolderLock() {
    if (fd_ >= 0) ::close(fd_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// False: the folder's file system, or its owner, refuses the lock.
  bool held() const noexcept { return held_; }

 private:
  int fd_;
  bool held_;
};

/// Whether there is a socket at which no process listens any more.
bool is_abandoned(const std::filesystem::path& path, const sockaddr_un& address) {
  struct stat status {};
  // a connection to a file that is not a socket is also refused
  if (::lstat(path.c_str(), &status) != 0 || !S_ISSOCK(status.st_mode)) return false;
  const int probe = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (probe < 0) return false;
  const bool refused =
      ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 && errno == ECONNREFUSED;
  ::close(probe);
  return refused;
}

}  // namespace

HubListener::HubListener(std::filesystem::path path) : path_(std::move(path)) {
  const sockaddr_un address = hub_address(path_.string());
  const FolderLock lock(path_.parent_path() / ".");
  if (lock.held() && is_abandoned(path_, address)) ::unlink(path_.c_str());
  fd_ = ::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  // before `bind`, which gives the file the socket's permissions: a process that may write to it can command drives
  if (fd_ >= 0 && ::fchmod(fd_, S_IRUSR | S_IWUSR) == 0 &&
      ::bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 && ::listen(fd_, 16) == 0)
    return;
  const std::string why = std::strerror(errno);
  if (fd_ >= 0) ::close(fd_);
  throw std::runtime_error("CAN hub '" + path_.string() + "': " + why + ", expected an unused path");
}

HubListener::~HubListener() {
  // the file first: while this listens, no other hub can replace the file to be removed
  ::unlink(path_.c_str());
  ::close(fd_);
}

}  // namespace mrroc::can
