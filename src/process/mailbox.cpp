#include "process/mailbox.hpp"

#include <algorithm>

#include "mrroc/errors.hpp"

namespace mrroc::process {

void Mailbox::put(const Message& parcel) {
  if (parcels_.size() == kCapacity) {
    throw NonFatalError(ErrorCode::busy, std::to_string(kCapacity) +
                                             " messages wait and have not been taken; there is no "
                                             "room for another, '" +
                                             std::string{parcel.label.view()} + "'");
  }
  parcels_.push_back(parcel);
}

bool Mailbox::take(std::string_view label, Message& parcel) noexcept {
  const auto found = std::find_if(parcels_.begin(), parcels_.end(),
                                  [label](const Message& waiting) { return waiting.label.view() == label; });
  if (found == parcels_.end()) return false;
  parcel = *found;
  parcels_.erase(found);
  return true;
}

bool Mailbox::has(std::string_view label) const noexcept {
  return std::any_of(parcels_.begin(), parcels_.end(),
                     [label](const Message& waiting) { return waiting.label.view() == label; });
}

}  // namespace mrroc::process
