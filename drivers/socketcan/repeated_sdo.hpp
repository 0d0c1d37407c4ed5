#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "canopen/pdo_mapping.hpp"
#include "canopen/sdo_client.hpp"
#include "clock/wall/monotonic.hpp"

/// SDO requests at the start, which are repeated once without an answer: a node that is booting does not answer. All
/// throw canopen::SdoError; one thread.
namespace mrroc::edp {

inline constexpr std::int64_t kSdoTimeout = clock::kSecond / 2;

template <class Transfer>
auto repeat_once(Transfer transfer) {
  try {
    return transfer();
  } catch (const canopen::SdoError& error) {
    if (error.abort() != canopen::SdoAbort::timeout) throw;
  }
  return transfer();
}

inline std::vector<std::uint8_t> upload_repeated(canopen::SdoClient& client, canopen::NodeId node,
                                                 canopen::Object object) {
  return repeat_once([&] { return client.upload(node, object); });
}

inline void download_repeated(canopen::SdoClient& client, canopen::NodeId node, canopen::Object object,
                              std::uint32_t value, std::uint8_t size) {
  repeat_once([&] { client.download(node, object, value, size); });
}

/// Switches off the PDO with these parameters: a PDO in use keeps its identifier (CiA 301), and the node may have its
/// own from its last set-up (1010h).
inline void free_pdo(canopen::SdoClient& client, canopen::NodeId node, std::uint16_t parameters) {
  const canopen::Object object{parameters, 1};
  const auto identifier = static_cast<std::uint32_t>(can::get(upload_repeated(client, node, object), 0, 4));
  if ((identifier & canopen::kPdoNotUsed) == 0)
    download_repeated(client, node, object, canopen::kPdoNotUsed | identifier, 4);
}

}  // namespace mrroc::edp
