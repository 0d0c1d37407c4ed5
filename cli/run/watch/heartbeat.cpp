#include "cli/run/watch/heartbeat.hpp"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <sys/random.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>

#include "core/number_text.hpp"

namespace mrroc::cli {

namespace {

constexpr std::uint64_t kMagic = 0x3162'6f72'726d'4d02;  // and version 2
constexpr std::size_t kWords = 8;
constexpr std::size_t kBody = kWords * 8;
constexpr std::size_t kCode = 16;  // the first half of the hash's 32 bytes

std::array<std::uint8_t, kCode> code_of(const std::uint8_t* body, const HeartbeatKey& key) {
  std::array<std::uint8_t, 32> hash{};
  unsigned size = 0;
  if (HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()), body, kBody, hash.data(), &size) == nullptr)
    throw std::runtime_error("no HMAC-SHA-256");
  std::array<std::uint8_t, kCode> code{};
  std::copy_n(hash.begin(), kCode, code.begin());
  return code;
}

}  // namespace

HeartbeatKey new_beat_key() {
  HeartbeatKey key{};
  if (getrandom(key.data(), key.size(), 0) != static_cast<ssize_t>(key.size()))
    throw std::runtime_error("no random numbers");
  return key;
}

std::vector<std::uint8_t> seal(const Heartbeat& beat, const HeartbeatKey& key) {
  const std::array<std::uint64_t, kWords> words{kMagic,
                                                beat.from_runner ? 1U : 0U,
                                                beat.sequence,
                                                static_cast<std::uint64_t>(beat.sent),
                                                static_cast<std::uint64_t>(beat.echo),
                                                static_cast<std::uint64_t>(beat.held),
                                                beat.presses,
                                                beat.resets};
  std::vector<std::uint8_t> datagram;
  for (const std::uint64_t word : words)
    for (int shift = 0; shift < 64; shift += 8) datagram.push_back(static_cast<std::uint8_t>(word >> shift));
  const auto code = code_of(datagram.data(), key);
  datagram.insert(datagram.end(), code.begin(), code.end());
  return datagram;
}

std::optional<Heartbeat> open(const std::uint8_t* data, std::size_t size, const HeartbeatKey& key) {
  if (size != kBody + kCode) return std::nullopt;
  if (const auto code = code_of(data, key); CRYPTO_memcmp(code.data(), data + kBody, kCode) != 0) return std::nullopt;
  std::array<std::uint64_t, kWords> words{};
  for (std::size_t i = 0; i < kBody; ++i) words[i / 8] |= std::uint64_t{data[i]} << (8 * (i % 8));
  if (words[0] != kMagic || words[1] > 1 || words[6] > UINT32_MAX || words[7] > UINT32_MAX) return std::nullopt;
  return Heartbeat{words[1] == 1,
                   words[2],
                   static_cast<std::int64_t>(words[3]),
                   static_cast<std::int64_t>(words[4]),
                   static_cast<std::int64_t>(words[5]),
                   static_cast<std::uint32_t>(words[6]),
                   static_cast<std::uint32_t>(words[7])};
}

std::string to_hex(const HeartbeatKey& key) { return core::hexadecimal(std::as_bytes(std::span(key))); }

std::optional<HeartbeatKey> key_of_hex(const std::string& text) {
  HeartbeatKey key{};
  const auto bytes = core::bytes_of_hexadecimal(text);
  if (!bytes || bytes->size() != key.size()) return std::nullopt;
  std::memcpy(key.data(), bytes->data(), key.size());
  return key;
}

}  // namespace mrroc::cli
