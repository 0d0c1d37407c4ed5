#include "process/record/claimed_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::process::claimed_file_test {
namespace {

namespace fs = std::filesystem;

class ClaimedFileTest : public testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) const { return folder_.write(name, text); }
  static std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// The refusal message in another process that claims the path; empty: none.
  static std::string refusal_of(const fs::path& path) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t pid = fork();
    if (pid == 0) {
      std::string text;
      try {
        const ClaimedFile file(path, "the file");
      } catch (const FileInUse& error) {
        text = error.what();
      } catch (const std::exception& error) {
        text = std::string{"not in use: "} + error.what();
      }
      _exit(::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
    }
    close(ends[1]);
    std::string text(1000, '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(::read(ends[0], text.data(), text.size()), 0)));
    close(ends[0]);
    int status = 0;
    waitpid(pid, &status, 0);
    return text;
  }

  task_test::ScratchFolder folder_;
};

TEST_F(ClaimedFileTest, AnotherProcessIsRefusedUnderAnyNameAndReportsTheOwner) {
  const fs::path path = write("file", "text");
  fs::create_symlink(path, folder_ / "link");
  fs::create_hard_link(path, folder_ / "twin");
  fs::create_directory(folder_ / "sub");
  fs::create_directory_symlink(folder_.path(), folder_ / "sub" / "up");
  const ClaimedFile file(path, "the file");
  for (const fs::path& name :
       {path, folder_ / "link", folder_ / "twin", folder_ / "sub/../file", folder_ / "sub/up/file"}) {
    const std::string refusal = refusal_of(name);
    EXPECT_NE(refusal.find(name.string() + ": is being written by process " + std::to_string(getpid())),
              std::string::npos)
        << refusal;
  }
  EXPECT_EQ(read(path), "text") << "the file was not truncated";
}

TEST_F(ClaimedFileTest, ReleasedFileCanBeClaimed) {
  const fs::path path = folder_ / "file";
  { const ClaimedFile file(path, "the file"); }
  EXPECT_EQ(refusal_of(path), "");
  const pid_t pid = fork();
  if (pid == 0) {
    const ClaimedFile file(path, "the file");
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(pid, &status, 0);
  EXPECT_EQ(refusal_of(path), "") << "its process was killed";
}

TEST_F(ClaimedFileTest, FifoIsClaimedWhenItHasAReader) {
  const fs::path path = folder_ / "fifo";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  EXPECT_TRUE(ClaimedFile(path, "the file").waits());
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  const ClaimedFile file(path, "the file");
  EXPECT_FALSE(file.waits());
  EXPECT_FALSE(file.is_own_regular_file());
  EXPECT_NE(refusal_of(path), "");
  close(reader);
}

TEST_F(ClaimedFileTest, DeviceIsShared) {
  const ClaimedFile file("/dev/null", "the file");
  EXPECT_EQ(refusal_of("/dev/null"), "");
}

TEST_F(ClaimedFileTest, DescriptorIsWrittenFromItsPosition) {
  const fs::path path = write("file", "before ");
  const int fd = open(path.c_str(), O_WRONLY | O_APPEND);  // as an inherited one
  {
    const ClaimedFile file("/dev/fd/" + std::to_string(fd), "the file");
    EXPECT_FALSE(file.is_own_regular_file()) << "it must not be truncated";
    EXPECT_EQ(::write(file.fd(), "after", 5), 5);
    EXPECT_NE(refusal_of(path), "");
  }
  EXPECT_EQ(read(path), "before after");
  close(fd);
  const int reads = open(path.c_str(), O_RDONLY);
  EXPECT_THROW(ClaimedFile("/proc/self/fd/" + std::to_string(reads), "the file"), std::runtime_error);
  close(reads);
  EXPECT_THROW(ClaimedFile("/dev/fd/987", "the file"), std::runtime_error) << "not open";
}

// a caller that forgets `3>file` must not get the file of a descriptor that the program has opened
TEST_F(ClaimedFileTest, OwnDescriptorIsNoOutput) {
  const fs::path path = write("memory", "its own");
  for (const int flags : {O_WRONLY, O_RDWR}) {
    const int own = open(path.c_str(), flags | O_CLOEXEC);
    for (const char* folder : {"/dev/fd/", "/proc/self/fd/"})
      EXPECT_THROW(ClaimedFile(folder + std::to_string(own), "the file"), std::runtime_error);
    close(own);
  }
  EXPECT_EQ(read(path), "its own");
}

TEST_F(ClaimedFileTest, RecognisesNamesOfDescriptors) {
  EXPECT_EQ(named_descriptor("/dev/stdout"), 1);
  EXPECT_EQ(named_descriptor("/dev/fd/7"), 7);
  EXPECT_EQ(named_descriptor("/proc/self/fd/63"), 63);
  EXPECT_EQ(named_descriptor("/dev/null"), -1);
  EXPECT_EQ(named_descriptor("no/such/file"), -1);
  fs::create_symlink("/dev/stderr", folder_ / "errors");
  EXPECT_EQ(named_descriptor(folder_ / "errors"), 2);
}

TEST_F(ClaimedFileTest, NewFilesTakeTheFirstFreeName) {
  const fs::path taken = write("box.mcap", "older");
  const auto name = [this](std::uint64_t number) {
    return folder_ / (number == 1 ? "box.mcap" : "box-" + std::to_string(number) + ".mcap");
  };
  const ClaimedFile second = ClaimedFile::create(name, "the box"), third = ClaimedFile::create(name, "the box");
  EXPECT_EQ(second.path(), folder_ / "box-2.mcap");
  EXPECT_EQ(third.number(), 3U);
  EXPECT_EQ(read(taken), "older");
}

TEST_F(ClaimedFileTest, FolderIsClaimedToo) {
  const ClaimedFile claimed = ClaimedFile::folder(folder_.path(), "the snapshots");
  EXPECT_THROW(ClaimedFile::folder(folder_ / ".", "the snapshots"), FileInUse);
  EXPECT_THROW(ClaimedFile::folder(folder_ / "none", "the snapshots"), std::runtime_error);
}

TEST_F(ClaimedFileTest, ReplacedFileIsNotInPlace) {
  const fs::path path = write("file", "");
  const ClaimedFile file(path, "the file");
  EXPECT_TRUE(file.in_place());
  fs::rename(write("other", ""), path);
  EXPECT_FALSE(file.in_place());
}

TEST_F(ClaimedFileTest, FileThatCannotBeOpenedIsNamedWithTheReason) {
  for (const char* path : {"/no/such/folder/file", "/proc", "/proc/version/file"}) {
    try {
      const ClaimedFile file(path, "the recording");
      ADD_FAILURE() << path;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string{error.what()}.find(std::string{"cannot write the recording "} + path + ": "), 0U)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace mrroc::process::claimed_file_test
