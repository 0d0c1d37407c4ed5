#pragma once

#include <cstddef>
#include <cstdint>

namespace mrroc::links {

/// The sender of a request, for the reply to it.
struct Caller {
  std::size_t client = 0;      ///< number of the client, in the order of the responder's list
  std::uint64_t sequence = 0;  ///< of the request on that client's link
};

}  // namespace mrroc::links
