// RTDE: what the servers do with the packages of a client.
#include <algorithm>
#include <cmath>

#include "drivers/ur/rtde/protocol_error.hpp"
#include "sim/ur/controller_client.hpp"

namespace mrroc::sim::ur {

using namespace mrroc::ur::rtde;

namespace {

constexpr std::size_t kMostHeld = 10000;

}  // namespace

void ControllerServers::answer(Client& client, std::uint8_t type, const std::vector<std::uint8_t>& payload) {
  append_packet(client.queued, static_cast<PacketType>(type), payload);
}

void ControllerServers::take_rtde(Client& client) {
  Packet packet;
  PacketBuffer::Next next = PacketBuffer::Next::incomplete;
  try {
    while ((next = client.packets.next(packet)) == PacketBuffer::Next::packet) {
      const auto type = static_cast<std::uint8_t>(packet.type);
      switch (packet.type) {
        case PacketType::request_protocol_version: {
          const auto request = VersionRequest::from_payload(packet.payload);
          answer(client, type, Acceptance{request.version == kProtocolVersion}.payload());
          break;
        }
        case PacketType::get_urcontrol_version:
          answer(client, type, controller_.version().payload());
          break;
        case PacketType::setup_outputs:
          set_up_outputs(client, packet.payload);
          break;
        case PacketType::setup_inputs:
          set_up_inputs(client, packet.payload);
          break;
        case PacketType::start:
        case PacketType::pause: {
          const bool starts = packet.type == PacketType::start;
          const bool accepted = client.output_recipe.id != 0;
          client.started = starts && accepted;
          answer(client, type, Acceptance{accepted}.payload());
          break;
        }
        case PacketType::data_package:
          take_data(client, packet.payload);
          break;
        case PacketType::text_message:
          break;
      }
    }
  } catch (const ProtocolError& error) {
    answer(client, static_cast<std::uint8_t>(PacketType::text_message),
           TextMessage{error.what(), "RTDE", TextMessage::Level::error}.payload());
    client.ended = true;
  }
  if (next == PacketBuffer::Next::broken) client.ended = true;
}

void ControllerServers::set_up_outputs(Client& client, Bytes payload) {
  const auto request = OutputsRequest::from_payload(payload);
  SetupReply reply{1, {}};
  client.outputs.clear();
  client.output_recipe = {1, {}};
  for (const std::string& name : request.names) {
    const VirtualController::Getter* const field = controller_.output(name);
    if (field == nullptr) {
      reply.types.emplace_back(kNotFound);
      reply.id = client.output_recipe.id = 0;
      continue;
    }
    const FieldType type = type_of((*field)());
    reply.types.emplace_back(name_of(type));
    client.outputs.push_back(field);
    client.output_recipe.types.push_back(type);
  }
  const double full = 1 / options_.controller.period;
  const double frequency = std::clamp(std::isfinite(request.frequency) ? request.frequency : full, 1.0, full);
  client.every = static_cast<std::uint64_t>(std::lround(full / frequency));
  answer(client, static_cast<std::uint8_t>(PacketType::setup_outputs), reply.payload());
}

bool ControllerServers::is_in_use(const Client& own, const std::string& name) const {
  return std::any_of(clients_.begin(), clients_.end(), [&](const Client& client) {
    return &client != &own && !client.ended &&
           std::any_of(client.inputs.begin(), client.inputs.end(), [&name](const auto& entry) {
             const auto& names = entry.second.names;
             return std::find(names.begin(), names.end(), name) != names.end();
           });
  });
}

void ControllerServers::set_up_inputs(Client& client, Bytes payload) {
  const auto request = InputsRequest::from_payload(payload);
  const auto id = static_cast<std::uint8_t>(client.inputs.size() + 1);
  SetupReply reply{id, {}};
  Client::InputRecipe recipe{{id, {}}, request.names, {}};
  for (const std::string& name : request.names) {
    const VirtualController::Input* const field = controller_.input(name);
    const bool used = field != nullptr && is_in_use(client, name);
    if (field == nullptr || used) {
      reply.types.emplace_back(used ? kInUse : kNotFound);
      reply.id = 0;
      continue;
    }
    reply.types.emplace_back(name_of(field->type));
    recipe.recipe.types.push_back(field->type);
    recipe.fields.push_back(field);
  }
  if (reply.id != 0) {
    const std::string number = lockstep_field();
    client.drives = client.drives || std::find(recipe.names.begin(), recipe.names.end(), number) != recipe.names.end();
    client.inputs.emplace(id, std::move(recipe));
  }
  answer(client, static_cast<std::uint8_t>(PacketType::setup_inputs), reply.payload());
}

void ControllerServers::take_data(Client& client, Bytes payload) {
  const auto found = payload.empty() ? client.inputs.end() : client.inputs.find(payload[0]);
  if (found == client.inputs.end()) throw ProtocolError("a data package of an unknown recipe");
  std::vector<Value> values(found->second.fields.size());
  if (!decode_data(found->second.recipe, payload, values))
    throw ProtocolError("a data package of another length than its recipe");
  for (std::size_t i = 0; i < values.size(); ++i) found->second.fields[i]->set(values[i]);
  if (client.drives)
    answered_ = controller_.registers().integer_inputs[static_cast<std::size_t>(*options_.lockstep_register)];
}

/// The field with the number of the driver's set-points; empty: not in lockstep.
std::string ControllerServers::lockstep_field() const {
  return options_.lockstep_register ? "input_int_register_" + std::to_string(*options_.lockstep_register) : "";
}

void ControllerServers::send_state(Client& client) {
  std::vector<Value> values;
  for (const VirtualController::Getter* field : client.outputs) values.push_back((*field)());
  std::vector<std::uint8_t> bytes(kHeaderSize + client.output_recipe.size());
  encode_data(client.output_recipe, values, bytes);
  const std::uint64_t due = steps_ + static_cast<std::uint64_t>(std::max(delay_, postpone_));
  for (int copies = repeat_ > 0 ? 2 : 1; copies > 0 && client.held.size() < kMostHeld; --copies)
    client.held.push_back({client.held.empty() ? due : std::max(due, client.held.back().due), bytes});
}

}  // namespace mrroc::sim::ur
