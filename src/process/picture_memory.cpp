#include "process/picture_memory.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/lockfree/sequence_lock.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::process {

namespace {

using Word = std::atomic<std::uint64_t>;
static_assert(sizeof(Word) == sizeof(std::uint64_t) && Word::is_always_lock_free);

constexpr const char* kPictureMemory = "memory of a camera's pictures";

std::size_t bytes_of(int width, int height) {
  return std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// The tick, then the pixels.
std::size_t words_of(std::size_t bytes) { return 1 + (bytes + sizeof(Word) - 1) / sizeof(Word); }

/// The sequence, then the words.
std::size_t size_of(std::size_t bytes) { return (1 + words_of(bytes)) * sizeof(Word); }

Word& sequence_in(const core::SharedMemory& memory) { return *static_cast<Word*>(memory.address()); }

core::SequencedWords words_in(const core::SharedMemory& memory, std::size_t count) {
  return {static_cast<Word*>(memory.address()) + 1, count};
}

}  // namespace

PictureMemory::PictureMemory(core::SharedMemory mapped, std::size_t bytes)
    : mapped_(std::move(mapped)), bytes_(bytes), words_(words_of(bytes)) {}

PictureMemory PictureMemory::create(int width, int height) {
  const std::size_t bytes = bytes_of(width, height);
  return {core::SharedMemory::create("mrroc-pictures", size_of(bytes), kPictureMemory), bytes};
}

PictureMemory PictureMemory::attach(int fd, int width, int height) {
  const std::size_t bytes = bytes_of(width, height);
  return {core::SharedMemory::attach(fd, size_of(bytes), kPictureMemory), bytes};
}

PictureMemory PictureMemory::open(const std::filesystem::path& file, int width, int height) {
  const int fd = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
  if (fd < 0)
    throw SystemError(ErrorCode::resources,
                      std::string{kPictureMemory} + ", " + file.string() + ": " + strerror(errno));
  const struct Closing {
    int fd;
    ~Closing() { close(fd); }
  } closing{fd};
  return attach(fd, width, height);
}

void PictureMemory::store(Tick tick, std::span<const std::uint8_t> pixels) noexcept {
  words_[0] = static_cast<std::uint64_t>(tick);
  std::memcpy(&words_[1], pixels.data(), bytes_);
  core::store_words(sequence_in(mapped_), words_in(mapped_, words_.size()), words_.data());
}

std::uint64_t PictureMemory::sequence() const noexcept { return sequence_in(mapped_).load(std::memory_order_acquire); }

bool PictureMemory::load(Tick& tick, std::vector<std::uint8_t>& pixels) {
  if (!core::load_words(sequence_in(mapped_), words_in(mapped_, words_.size()), words_.data())) return false;
  tick = static_cast<Tick>(words_[0]);
  pixels.resize(bytes_);
  std::memcpy(pixels.data(), &words_[1], bytes_);
  return true;
}

}  // namespace mrroc::process
