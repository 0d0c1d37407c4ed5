#include "process/record/claimed_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "command/printable.hpp"

namespace mrroc::process {

namespace {

constexpr int kToWrite = O_WRONLY | O_CREAT | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
constexpr int kNew = O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC;
constexpr mode_t kMode = 0666;
constexpr std::uint64_t kMostNumbers = 1'000'000;

FileIdentity identity_of(const struct stat& status) noexcept { return {status.st_dev, status.st_ino}; }

std::string command_of(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/cmdline", std::ios::binary);
  std::string words((std::istreambuf_iterator<char>(file)), {});
  for (char& character : words)
    if (character == '\0') character = ' ';
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words.empty() ? "" : " (" + command::printable(words.substr(0, 200)) + ")";
}

/// The process that holds the lock, from the kernel's list (proc(5), /proc/locks).
std::string holder_of(const FileIdentity& file) {
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    std::istringstream words(line);
    std::string number, kind, advisory, access, pid, place;
    words >> number >> kind >> advisory >> access >> pid >> place;
    unsigned int major_number = 0, minor_number = 0;
    unsigned long inode = 0;
    if (kind != "FLOCK" || std::sscanf(place.c_str(), "%x:%x:%lu", &major_number, &minor_number, &inode) != 3) continue;
    if (inode != file.number || makedev(major_number, minor_number) != file.device) continue;
    if (pid == std::to_string(getpid())) return "this process";
    return "process " + pid + command_of(pid);
  }
  return "another process";  // in another container, or on another host
}

/// A new description of the file of `fd`; -1: the kernel cannot open it a second time, as for a socket.
int reopen(int fd, int flags) {
  return ::open(("/proc/self/fd/" + std::to_string(fd)).c_str(), flags | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}

}  // namespace

int named_descriptor(const std::filesystem::path& path) {
  std::error_code none;
  std::filesystem::path place = std::filesystem::absolute(path, none).lexically_normal();
  // the kernel's own links lead away from their names: the last one is not followed
  for (int links = 0; links < 40; ++links) {
    const std::filesystem::path folder = std::filesystem::canonical(place.parent_path(), none);
    const std::string name = place.filename().string();
    if (!none && folder == "/proc/" + std::to_string(getpid()) + "/fd") {
      int number = -1;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
      return error == std::errc{} && end == name.data() + name.size() ? number : -1;
    }
    const std::filesystem::path target = std::filesystem::read_symlink(place, none);
    if (none) return -1;
    place = (place.parent_path() / target).lexically_normal();
  }
  return -1;
}

FileIdentity identity_of(const std::filesystem::path& path) noexcept {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? identity_of(status) : FileIdentity{};
}

FileIdentity identity_of(int fd) noexcept {
  struct stat status {};
  return ::fstat(fd, &status) == 0 ? identity_of(status) : FileIdentity{};
}

ClaimedFile::ClaimedFile(std::filesystem::path path, const std::string& what) : path_(std::move(path)) {
  const int named = named_descriptor(path_);
  own_ = named < 0;
  for (;;) {
    struct stat status {};
    if (own_) {
      fd_ = ::open(path_.c_str(), kToWrite, kMode);
    } else if (const int closed = fcntl(named, F_GETFD); closed < 0 || (closed & FD_CLOEXEC) != 0) {
      refuse(what, "is not open");  // or is one of this program's own
    } else if (const int flags = fcntl(named, F_GETFL); flags < 0 || (flags & O_ACCMODE) == O_RDONLY) {
      refuse(what, flags < 0 ? std::strerror(errno) : "is not open for writing");
    } else if (fstat(named, &status) == 0 && (S_ISREG(status.st_mode) || S_ISSOCK(status.st_mode))) {
      fd_ = fcntl(named, F_DUPFD_CLOEXEC, 3);
      lock_ = S_ISREG(status.st_mode) ? reopen(named, O_RDONLY) : -1;
      if (lock_ < 0) lock_ = S_ISREG(status.st_mode) ? reopen(named, O_WRONLY) : -1;
    } else {
      fd_ = reopen(named, O_WRONLY);
    }
    if (fd_ < 0) {
      const int reason = errno;
      if (reason == ENXIO && ::stat(path_.c_str(), &status) == 0 && S_ISFIFO(status.st_mode) && own_) return;
      refuse(what, reason == ENXIO ? "no process reads it" : std::strerror(reason));
    }
    if (fstat(fd_, &status) != 0) refuse(what, std::strerror(errno));
    mode_ = status.st_mode;
    identity_ = identity_of(status);
    if (lock_ < 0) lock_ = fd_;
    lock(what);
    if (!own_ || in_place()) return;
    close();  // another claim has removed it between the two calls
  }
}

ClaimedFile ClaimedFile::create(const std::function<std::filesystem::path(std::uint64_t number)>& name,
                                const std::string& what) {
  ClaimedFile file;
  for (std::uint64_t number = 1;; ++number) {
    file.path_ = name(number);
    file.number_ = number;
    file.fd_ = file.lock_ = ::open(file.path_.c_str(), kNew, kMode);
    if (file.fd_ >= 0) break;
    if (errno != EEXIST || number == kMostNumbers) file.refuse(what, std::strerror(errno));
  }
  file.take_created(what);
  return file;
}

ClaimedFile ClaimedFile::create(const std::filesystem::path& path, const std::string& what) {
  ClaimedFile file;
  file.path_ = path;
  file.fd_ = file.lock_ = ::open(path.c_str(), kNew, kMode);
  if (file.fd_ < 0) file.refuse(what, errno == EEXIST ? "is a file that exists" : std::strerror(errno));
  file.take_created(what);
  return file;
}

ClaimedFile ClaimedFile::folder(std::filesystem::path path, const std::string& what) {
  ClaimedFile file;
  file.path_ = std::move(path);
  file.fd_ = file.lock_ = ::open(file.path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file.fd_ < 0) file.refuse(what, std::strerror(errno));
  file.mode_ = S_IFDIR;
  file.identity_ = process::identity_of(file.fd_);
  file.lock(what);
  return file;
}

ClaimedFile::~ClaimedFile() { close(); }

ClaimedFile::ClaimedFile(ClaimedFile&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      lock_(std::exchange(other.lock_, -1)),
      own_(other.own_),
      number_(other.number_),
      mode_(other.mode_),
      identity_(other.identity_) {}

void ClaimedFile::take_created(const std::string& what) {
  struct stat status {};
  if (fstat(fd_, &status) != 0) refuse(what, std::strerror(errno));
  mode_ = status.st_mode;
  identity_ = process::identity_of(fd_);
  lock(what);
}

void ClaimedFile::lock(const std::string& what) {
  if (S_ISCHR(mode_) || S_ISSOCK(mode_)) return;
  while (flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return;  // a file system without locks
    const std::string holder = holder_of(identity_);
    close();
    throw FileInUse(
        std::string(what).append(" ").append(path_.string()).append(": is being written by ").append(holder) +
        ", expected a file that no other run writes");
  }
}

void ClaimedFile::refuse(const std::string& what, const std::string& why) {
  close();
  const bool sentence = why.starts_with("is ") || why.starts_with("no process");
  throw std::runtime_error(sentence ? what + " " + path_.string() + ": " + why
                                    : "cannot write " + what + " " + path_.string() + ": " + why);
}

bool ClaimedFile::in_place() const noexcept { return process::identity_of(path_) == identity_; }

int ClaimedFile::write(std::string_view text) const noexcept {
  while (!text.empty()) {
    const ssize_t size = ::write(fd_, text.data(), text.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return size < 0 ? errno : EIO;
    text.remove_prefix(static_cast<std::size_t>(size));
  }
  return 0;
}

int ClaimedFile::close() noexcept {
  if (lock_ >= 0 && lock_ != fd_) ::close(lock_);
  lock_ = -1;
  return fd_ >= 0 && ::close(std::exchange(fd_, -1)) != 0 ? errno : 0;
}

}  // namespace mrroc::process
