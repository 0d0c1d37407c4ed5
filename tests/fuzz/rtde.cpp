// Bytes in pieces of any length, as a socket returns them: the packages in them, their contents, and data packages of a
// recipe.
#include <algorithm>

#include "drivers/ur/rtde/messages.hpp"
#include "drivers/ur/rtde/packet.hpp"
#include "drivers/ur/rtde/protocol_error.hpp"
#include "fuzz/fuzz.hpp"

namespace {

using namespace mrroc::ur::rtde;

/// A message that is read is written with the same bytes, unless a list ends with a comma.
template <class Message>
void check_message(Bytes payload) {
  fuzz::refuses<ProtocolError>([payload] {
    const std::vector<std::uint8_t> written = Message::from_payload(payload).payload();
    const std::vector<std::uint8_t> again = Message::from_payload(written).payload();
    fuzz::require(written == again, "a written message round-trips");
    fuzz::require(written.size() <= payload.size(), "a written message has no more bytes");
  });
}

void check_data(const Recipe& recipe, Bytes payload) {
  std::vector<Value> values(recipe.types.size());
  if (!decode_data(recipe, payload, values)) return;
  std::vector<std::uint8_t> written(kHeaderSize + payload.size());
  written.resize(encode_data(recipe, values, written));
  fuzz::require(written.size() == payload.size() + kHeaderSize, "a data package has its recipe's length");
  for (std::size_t i = 0, at = kHeaderSize + 1; i < values.size(); at += size_of(recipe.types[i]), ++i)
    fuzz::require(recipe.types[i] == FieldType::boolean ||
                      std::equal(written.begin() + static_cast<std::ptrdiff_t>(at),
                                 written.begin() + static_cast<std::ptrdiff_t>(at + size_of(recipe.types[i])),
                                 payload.begin() + static_cast<std::ptrdiff_t>(at - kHeaderSize)),
                  "a value round-trips");
}

void check(const Packet& packet, Recipe& recipe) {
  switch (packet.type) {
    case PacketType::request_protocol_version:
      check_message<VersionRequest>(packet.payload);
      return check_message<Acceptance>(packet.payload);
    case PacketType::get_urcontrol_version:
      return check_message<ControllerVersion>(packet.payload);
    case PacketType::text_message:
      return check_message<TextMessage>(packet.payload);
    case PacketType::setup_outputs:
      return check_message<OutputsRequest>(packet.payload);
    case PacketType::setup_inputs:
      check_message<InputsRequest>(packet.payload);
      check_message<SetupReply>(packet.payload);
      fuzz::refuses<ProtocolError>([&] {
        const SetupReply reply = SetupReply::from_payload(packet.payload);
        const std::vector<std::string> names(reply.types.size(), "a_field");
        recipe = accepted_recipe(reply, names);
      });
      return;
    case PacketType::data_package:
      return check_data(recipe, packet.payload);
    case PacketType::start:
    case PacketType::pause:
      return check_message<Acceptance>(packet.payload);
  }
  fuzz::require(false, "a package is of a known kind");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static PacketBuffer buffer;
  buffer.clear();
  Recipe recipe{1, {FieldType::real, FieldType::vector6d, FieldType::boolean}};
  fuzz::Bytes input(data, size);
  const std::size_t piece = 1 + input.take<std::uint8_t>();
  while (!input.empty()) {
    const std::size_t taken = std::min(piece, input.rest().size());
    input.take(buffer.free_space().data(), taken);
    buffer.filled(taken);
    Packet packet;
    PacketBuffer::Next next;
    while ((next = buffer.next(packet)) == PacketBuffer::Next::packet) check(packet, recipe);
    if (next == PacketBuffer::Next::broken) return 0;
  }
  return 0;
}
