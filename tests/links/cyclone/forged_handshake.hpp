#pragma once

#include <cstdint>
#include <string>

#include "links/cyclone/forged_packets.hpp"

namespace mrroc::links {

/// Common Data Representation, little-endian: alignment is relative to its beginning.
class Representation {
 public:
  Representation& word(std::uint32_t value) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    bytes_.append(reinterpret_cast<const char*>(&value), 4);
    return *this;
  }
  Representation& guid(const Guid& value) {
    bytes_.append(value.begin(), value.end());
    return *this;
  }
  Representation& text(const std::string& value) {
    word(static_cast<std::uint32_t>(value.size()) + 1);
    bytes_.append(value.c_str(), value.size() + 1);
    return *this;
  }
  const std::string& bytes() {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    return bytes_;
  }

 private:
  std::string bytes_;
};

/// One of a participant's entities, by its number.
inline Guid entity_of(Guid participant, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) participant[12 + i] = static_cast<std::uint8_t>(number >> (24 - 8 * i));
  return participant;
}

constexpr int kPlain = 1, kParameters = 3;  // encapsulations, little-endian

constexpr int kNoPayload = 0, kDataPayload = 0x04, kKeyPayload = 0x08;  // kind of a payload

/// A DATA submessage (RTPS 2.3, 9.4.5.3) of `writer`.
inline std::string forged_data(const Guid& writer, const Guid& reader, int encapsulation, const std::string& payload,
                               int kind = kDataPayload) {
  Packet packet(writer);
  packet.raw({0x15, 0x01 | kind}).half(static_cast<int>(20 + 4 + payload.size())).half(0).half(16);
  packet.append(reader.data() + 12, 4).append(writer.data() + 12, 4).sequence(1);
  packet.raw({0x00, encapsulation}).half(0).append(payload.data(), payload.size());
  return packet.bytes();
}

/// A part of a sample from byte `begin`, a multiple of 1000, to `end` (DATA_FRAG, 9.4.5.4), in fragments of 1000.
inline std::string forged_fragment(const Guid& writer, const Guid& reader, std::uint32_t begin, std::uint32_t end,
                                   std::uint32_t sample_size, bool only_key = false) {
  constexpr std::uint32_t kFragment = 1000;
  std::string payload(end - begin, 'A');
  if (begin == 0) payload.replace(0, 4, std::string{0, kPlain, 0, 0});
  Packet packet(writer);
  packet.raw({0x16, only_key ? 0x05 : 0x01}).half(0).half(0).half(28);  // the last submessage may omit its length
  packet.append(reader.data() + 12, 4).append(writer.data() + 12, 4).sequence(1);
  packet.word(begin / kFragment + 1)
      .half(static_cast<int>((end - begin) / kFragment))
      .half(kFragment)
      .word(sample_size);
  return packet.append(payload.data(), payload.size()).bytes();
}

constexpr std::uint32_t kPlainEndpoints = 0x3f, kSecureEndpoints = kPlainEndpoints | 3U << 22 | 3U << 26;
constexpr int kTypeInformation = 0x0075, kIdentityToken = 0x1001;  // numbers of parameters

/// "I am a participant", with these endpoints and one more parameter (RTPS 2.3, 8.5.3.2).
inline std::string forged_announcement(const Guid& participant, std::uint32_t endpoints, int parameter,
                                       const std::string& value) {
  Packet parameters(participant);
  const std::size_t header = parameters.bytes().size();
  parameters.half(0x0050).half(16).append(participant.data(), 16);
  parameters.half(0x0058).half(4).word(endpoints);
  parameters.half(parameter).half(static_cast<int>(value.size())).append(value.data(), value.size()).half(1).half(0);
  return forged_data(entity_of(participant, 0x000100c2), entity_of(participant, 0x000100c7), kParameters,
                     parameters.bytes().substr(header));
}

/// "I am a participant with keys", with an identity token of an unknown class (DDS Security 1.1, 7.4.1.3).
inline std::string forged_identity(const Guid& participant) {
  return forged_announcement(participant, kSecureEndpoints, kIdentityToken,
                             Representation{}.text("DDS:Auth:none").word(0).word(0).bytes());
}

/// "Let us prove our keys": a handshake request without a preceding one (DDS Security 1.1, 7.4.3 and 8.3.2.9.1).
inline std::string forged_handshake(const Guid& participant, const Guid& victim) {
  const Guid none{};
  Representation message;
  message.guid(participant).word(0).word(1).guid(none).word(0).word(0).guid(victim).guid(none).guid(none);
  message.text("dds.sec.auth").word(1).text("DDS:Auth:PKI-DH:1.0+Req").word(0).word(0);
  return forged_data(entity_of(participant, 0x000201c3), entity_of(victim, 0x000201c4), kPlain, message.bytes());
}

}  // namespace mrroc::links
