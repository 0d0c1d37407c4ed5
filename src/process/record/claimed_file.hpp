#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mrroc::process {

/// Identity of the file of a path or a descriptor, through any links.
struct FileIdentity {
  dev_t device = 0;
  ino_t number = 0;
  bool operator==(const FileIdentity&) const = default;
};

/// Another claim has the file.
class FileInUse : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that only this object writes: opened, not emptied, and locked (flock(2)) against every other claim, in this
/// process, in another one and, if the file system supports it, on another host. The kernel releases the lock when the
/// last process with the descriptor ends or dies, so a remaining file is free. Devices (/dev/null, a terminal) are not
/// locked. Any thread.
class ClaimedFile {
 public:
  /// Opens a file for writing, and creates it when it is missing. Does not wait for the reader of a FIFO: `waits` is
  /// then true. `/dev/fd/N`, `/dev/stdout` and the like are the open descriptor itself, at its present position. `what`
  /// is the caller's name for it, "the recording". Throws std::runtime_error with that name, the file and the reason;
  /// FileInUse with the process that writes it.
  ClaimedFile(std::filesystem::path path, const std::string& what);
  /// Creates the first of `name(1)`, `name(2)`, ... that does not exist. Throws std::runtime_error when this fails.
  static ClaimedFile create(const std::function<std::filesystem::path(std::uint64_t number)>& name,
                            const std::string& what);
  /// Creates this file. Throws std::runtime_error when it exists or cannot be created.
  static ClaimedFile create(const std::filesystem::path& path, const std::string& what);
  /// A folder that exists: the caller must separate the files that are written into it under other names.
  static ClaimedFile folder(std::filesystem::path path, const std::string& what);
  ~ClaimedFile();
  ClaimedFile(ClaimedFile&& other) noexcept;
  ClaimedFile& operator=(ClaimedFile&&) = delete;

  /// -1: a FIFO without a reader.
  int fd() const noexcept { return fd_; }
  bool waits() const noexcept { return fd_ < 0; }
  const std::filesystem::path& path() const noexcept { return path_; }
  /// Of `create`: the number of the name.
  std::uint64_t number() const noexcept { return number_; }
  const FileIdentity& identity() const noexcept { return identity_; }
  /// A regular file under its own name, not the file of a descriptor: it may be emptied.
  bool is_own_regular_file() const noexcept { return own_ && S_ISREG(mode_); }
  mode_t mode() const noexcept { return mode_; }
  /// Whether the path still leads to this file: it has not been removed or replaced.
  bool in_place() const noexcept;
  /// Writes the whole text. Returns 0, or the errno.
  int write(std::string_view text) const noexcept;
  /// Closes it, which may be when a file system reports a full disk. Returns 0, or the errno.
  int close() noexcept;

 private:
  ClaimedFile() = default;
  void take_created(const std::string& what);
  void lock(const std::string& what);
  [[noreturn]] void refuse(const std::string& what, const std::string& why);

  std::filesystem::path path_;
  int fd_ = -1;
  int lock_ = -1;  // fd_, or another one of the same file where fd_ is shared with other processes
  bool own_ = true;
  std::uint64_t number_ = 0;
  mode_t mode_ = 0;
  FileIdentity identity_;
};

/// The descriptor that `/dev/stdout`, `/dev/fd/N`, `/proc/self/fd/N` or a symbolic link to one names; -1: another path.
int named_descriptor(const std::filesystem::path& path);

/// Identity of the file of the path; all zero when it does not exist.
FileIdentity identity_of(const std::filesystem::path& path) noexcept;
FileIdentity identity_of(int fd) noexcept;

}  // namespace mrroc::process
