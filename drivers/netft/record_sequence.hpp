#pragma once

#include <cstdint>

namespace mrroc::netft {

/// Where a record is in its stream.
enum class Place {
  newest,    ///< it follows all records so far, perhaps behind lost ones
  late,      ///< it was counted as lost and has been overtaken
  doubled,   ///< it has been received before
  restarted  ///< the numbers have begun again: the sensor, or its stream, has restarted
};

/// Accounts for the records of one stream by their 32-bit sequence numbers, which wrap around: lost, late and doubled
/// ones. The newest kWindow numbers are remembered one by one; a number further back, or more than kMaxGap ahead, is
/// that of a stream that has restarted. One thread; allocates nothing.
class RecordSequence {
 public:
  static constexpr std::uint32_t kWindow = 64;
  /// Numbers between two records of the same stream; at 7 kHz nearly 10 minutes.
  static constexpr std::uint32_t kMaxGap = 1u << 22;

  Place add(std::uint32_t number) noexcept {
    ++received_;
    if (!open_) return begin(number), Place::newest;
    const std::uint32_t ahead = number - newest_;
    if (ahead != 0 && ahead <= kMaxGap) return advance(ahead), Place::newest;
    const std::uint32_t behind = newest_ - number;
    if (behind >= kWindow) {
      ++restarts_;
      return begin(number), Place::restarted;
    }
    const std::uint64_t bit = std::uint64_t{1} << behind;
    if ((seen_ & bit) != 0) {
      ++doubled_;
      return Place::doubled;
    }
    seen_ |= bit;
    if (behind < length_) --lost_;  // otherwise it was sent before the first one here
    ++late_;
    return Place::late;
  }

  /// The next record begins a new stream, whatever its number; the counters remain.
  void renew() noexcept { open_ = false; }

  std::uint64_t received() const noexcept { return received_; }
  std::uint64_t lost() const noexcept { return lost_; }  ///< without those that came late
  std::uint64_t late() const noexcept { return late_; }
  std::uint64_t doubled() const noexcept { return doubled_; }
  std::uint64_t restarts() const noexcept { return restarts_; }  ///< without those of `renew`

 private:
  void begin(std::uint32_t number) noexcept {
    open_ = true;
    newest_ = number;
    seen_ = 1;
    length_ = 1;
  }

  void advance(std::uint32_t ahead) noexcept {
    newest_ += ahead;
    lost_ += ahead - 1;
    length_ += ahead;
    seen_ = ahead < kWindow ? seen_ << ahead | 1 : 1;
  }

  bool open_ = false;
  std::uint32_t newest_ = 0;
  std::uint64_t seen_ = 0;    ///< bit i: newest_ - i has been received
  std::uint64_t length_ = 0;  ///< numbers from the first one of the stream to newest_
  std::uint64_t received_ = 0, lost_ = 0, late_ = 0, doubled_ = 0, restarts_ = 0;
};

}  // namespace mrroc::netft
