#include "drivers/ur/rtde/messages.hpp"

#include <algorithm>

#include "drivers/ur/rtde/protocol_error.hpp"

namespace mrroc::ur::rtde {
namespace {

constexpr std::size_t kMaxText = 255;

void check_complete(const WireReader& reader, const char* package, std::size_t size) {
  if (reader.complete()) return;
  throw ProtocolError(std::string(package) + ": a payload of " + std::to_string(size) + " bytes is too " +
                      (reader.ok() ? "long" : "short"));
}

/// Field names and types are letters, digits and underscores.
void check_names(const std::vector<std::string>& names, const char* package) {
  const auto good = [](const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
  };
  if (!std::all_of(names.begin(), names.end(), good))
    throw ProtocolError(std::string(package) + ": a list with a name that is not one of letters, digits, underscores");
}

template <class... Values>
std::vector<std::uint8_t> packed(std::string_view text, Values... values) {
  std::vector<std::uint8_t> bytes((sizeof(Values) + ... + text.size()));
  WireWriter writer(bytes);
  (writer.put(values), ...);
  writer.put_text(text);
  return bytes;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

VersionRequest VersionRequest::from_payload(Bytes payload) {
  WireReader reader(payload);
  const VersionRequest request{reader.take<std::uint16_t>()};
  check_complete(reader, "REQUEST_PROTOCOL_VERSION", payload.size());
  return request;
}
std::vector<std::uint8_t> VersionRequest::payload() const { return packed("", version); }

Acceptance Acceptance::from_payload(Bytes payload) {
  WireReader reader(payload);
  const Acceptance acceptance{reader.take<std::uint8_t>() != 0};
  check_complete(reader, "an answer", payload.size());
  return acceptance;
}
std::vector<std::uint8_t> Acceptance::payload() const { return packed("", static_cast<std::uint8_t>(accepted)); }

ControllerVersion ControllerVersion::from_payload(Bytes payload) {
  WireReader reader(payload);
  ControllerVersion version;
  version.major = reader.take<std::uint32_t>();
  version.minor = reader.take<std::uint32_t>();
  version.bugfix = reader.take<std::uint32_t>();
  version.build = reader.take<std::uint32_t>();
  check_complete(reader, "GET_URCONTROL_VERSION", payload.size());
  return version;
}
std::vector<std::uint8_t> ControllerVersion::payload() const { return packed("", major, minor, bugfix, build); }

std::string describe(const ControllerVersion& version) {
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.bugfix) +
         "." + std::to_string(version.build);
}

TextMessage TextMessage::from_payload(Bytes payload) {
  WireReader reader(payload);
  TextMessage text;
  text.message = reader.take_text(reader.take<std::uint8_t>());
  text.source = reader.take_text(reader.take<std::uint8_t>());
  const auto level = reader.take<std::uint8_t>();
  check_complete(reader, "TEXT_MESSAGE", payload.size());
  if (level > static_cast<std::uint8_t>(Level::info))
    throw ProtocolError("TEXT_MESSAGE: level " + std::to_string(level) + ", expected 0 to 3");
  text.level = static_cast<Level>(level);
  return text;
}

std::vector<std::uint8_t> TextMessage::payload() const {
  std::vector<std::uint8_t> bytes(3 + 2 * kMaxText);
  WireWriter writer(bytes);
  for (const std::string& text : {message, source}) {
    const std::string_view shown = std::string_view(text).substr(0, kMaxText);
    writer.put(static_cast<std::uint8_t>(shown.size()));
    writer.put_text(shown);
  }
  writer.put(static_cast<std::uint8_t>(level));
  bytes.resize(writer.size());
  return bytes;
}

OutputsRequest OutputsRequest::from_payload(Bytes payload) {
  WireReader reader(payload);
  OutputsRequest request;
  request.frequency = reader.take<double>();
  request.names = split_names(reader.take_rest());
  check_complete(reader, "SETUP_OUTPUTS", payload.size());
  check_names(request.names, "SETUP_OUTPUTS");
  return request;
}
std::vector<std::uint8_t> OutputsRequest::payload() const { return packed(join_names(names), frequency); }

InputsRequest InputsRequest::from_payload(Bytes payload) {
  WireReader reader(payload);
  InputsRequest request{split_names(reader.take_rest())};
  check_names(request.names, "SETUP_INPUTS");
  return request;
}
std::vector<std::uint8_t> InputsRequest::payload() const { return packed(join_names(names)); }

SetupReply SetupReply::from_payload(Bytes payload) {
  WireReader reader(payload);
  SetupReply reply;
  reply.id = reader.take<std::uint8_t>();
  reply.types = split_names(reader.take_rest());
  check_complete(reader, "an answer to a set-up", payload.size());
  check_names(reply.types, "an answer to a set-up");
  return reply;
}
std::vector<std::uint8_t> SetupReply::payload() const { return packed(join_names(types), id); }

Recipe accepted_recipe(const SetupReply& reply, std::span<const std::string> names) {
  if (reply.types.size() != names.size())
    throw ProtocolError("the controller answers with " + std::to_string(reply.types.size()) +
                        " types to a request of " + std::to_string(names.size()) + " fields");
  Recipe recipe{reply.id, {}};
  std::vector<std::string> missing, used, unknown;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& type = reply.types[i];
    if (type == kNotFound)
      missing.push_back(names[i]);
    else if (type == kInUse)
      used.push_back(names[i]);
    else if (const auto known = field_type(type))
      recipe.types.push_back(*known);
    else
      unknown.push_back(names[i] + " (" + type + ")");
  }
  std::string problem;
  if (!missing.empty()) problem += "; the controller's software does not have: " + listed(missing);
  if (!used.empty()) problem += "; another RTDE client, a fieldbus or MODBUS of the controller writes: " + listed(used);
  if (!unknown.empty()) problem += "; fields of an unknown type: " + listed(unknown);
  if (!problem.empty()) throw ProtocolError(problem.substr(2));
  if (recipe.id == 0) throw ProtocolError("the controller refuses a recipe of " + listed({names.begin(), names.end()}));
  return recipe;
}

}  // namespace mrroc::ur::rtde
