#include "links/transport/incompatible.hpp"

namespace mrroc::links {

std::string incompatible(const std::string& topic, std::uint32_t policy) {
  constexpr std::uint32_t kTypeConsistency = 24;
  if (policy == 0) return {};
  if (policy == kTypeConsistency) {
    return "topic " + topic + ": a peer has another message type (DDS policy 24): it was built from other sources";
  }
  return "topic " + topic + ": a peer has other link settings (DDS policy " + std::to_string(policy) + ")";
}

}  // namespace mrroc::links
