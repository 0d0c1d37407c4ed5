#pragma once

#include <string_view>
#include <vector>

#include "mrroc/parcel.hpp"

namespace mrroc::process {

/// The messages that a program has received and not taken yet, oldest first. Neither allocates after construction nor
/// waits. Task's thread.
class Mailbox {
 public:
  /// More than a correct program leaves untaken.
  static constexpr std::size_t kCapacity = 32;

  Mailbox() { parcels_.reserve(kCapacity); }

  /// Throws NonFatalError(busy) when it is full: the program does not take its messages.
  void put(const Message& parcel);
  /// The oldest message with this label; false when there is no such message.
  bool take(std::string_view label, Message& parcel) noexcept;
  bool has(std::string_view label) const noexcept;
  void clear() noexcept { parcels_.clear(); }

 private:
  std::vector<Message> parcels_;
};

}  // namespace mrroc::process
