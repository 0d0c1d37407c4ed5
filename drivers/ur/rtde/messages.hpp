#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "drivers/ur/rtde/recipe.hpp"

/// The payloads of the packages that set a connection up, of protocol version 2. `from_payload` throws ProtocolError
/// that names the package when its length or a text in it is wrong; `payload` returns the bytes.
namespace mrroc::ur::rtde {

inline constexpr std::uint16_t kProtocolVersion = 2;

/// REQUEST_PROTOCOL_VERSION, client to controller.
struct VersionRequest {
  std::uint16_t version = kProtocolVersion;
  static VersionRequest from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
};

/// The controller's answer to REQUEST_PROTOCOL_VERSION, START and PAUSE.
struct Acceptance {
  bool accepted = false;
  static Acceptance from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
};

/// Version of the controller's software.
struct ControllerVersion {
  std::uint32_t major = 0, minor = 0, bugfix = 0, build = 0;
  static ControllerVersion from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
  friend auto operator<=>(const ControllerVersion&, const ControllerVersion&) = default;
};
std::string describe(const ControllerVersion& version);
/// False: a CB3.
inline bool is_e_series(const ControllerVersion& version) noexcept { return version.major >= 5; }

/// TEXT_MESSAGE of the controller.
struct TextMessage {
  enum class Level : std::uint8_t { exception, error, warning, info };
  std::string message;  ///< up to 255 bytes
  std::string source;   ///< up to 255 bytes
  Level level = Level::info;
  static TextMessage from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
};

/// CONTROL_PACKAGE_SETUP_OUTPUTS, client to controller.
struct OutputsRequest {
  double frequency = 0;  ///< Hz
  std::vector<std::string> names;
  static OutputsRequest from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
};

/// CONTROL_PACKAGE_SETUP_INPUTS, client to controller.
struct InputsRequest {
  std::vector<std::string> names;
  static InputsRequest from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
};

/// The controller's answer to both set-ups: types of the fields by name, "NOT_FOUND" for a field that it does not have,
/// and "IN_USE" for an input that another client writes.
struct SetupReply {
  std::uint8_t id = 0;  ///< of the recipe; 0: there is no recipe
  std::vector<std::string> types;
  static SetupReply from_payload(Bytes payload);
  std::vector<std::uint8_t> payload() const;
};
inline constexpr std::string_view kNotFound = "NOT_FOUND";
inline constexpr std::string_view kInUse = "IN_USE";

/// The recipe of a reply to a request for `names`. Throws ProtocolError that lists the fields that the controller does
/// not have, those that are in use, and those of an unknown type, or that reports another number of fields.
Recipe accepted_recipe(const SetupReply& reply, std::span<const std::string> names);

}  // namespace mrroc::ur::rtde
