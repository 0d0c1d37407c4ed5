#pragma once

#include <compare>
#include <cstdint>

namespace mrroc::canopen {

/// Address of a value in a node's object dictionary.
struct Object {
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  friend constexpr auto operator<=>(const Object&, const Object&) = default;
};

/// Axes of one drive at most; the profile of each has 800h objects, from 6000h on (CiA 301, 7.4.1).
inline constexpr int kMaxChannels = 8;
inline constexpr std::uint16_t kProfile = 0x6000, kObjectsOfChannel = 0x800;

/// Of the profile of some axis, not of the communication or the manufacturer.
constexpr bool is_of_profile(Object object) noexcept {
  return object.index >= kProfile && object.index < kProfile + kMaxChannels * kObjectsOfChannel;
}

/// The object of axis `channel`, from 1, of a drive with several axes, for an object of the first one. Objects outside
/// the profile of the first one stay as they are.
constexpr Object of_channel(Object object, int channel) noexcept {
  if (object.index >= kProfile && object.index < kProfile + kObjectsOfChannel)
    object.index = static_cast<std::uint16_t>(object.index + kObjectsOfChannel * (channel - 1));
  return object;
}

/// Number of the first RPDO and TPDO of axis `channel`: 1, 65, 129 ... (CiA 301, 7.5.2.33).
constexpr int first_pdo_of_channel(int channel) noexcept { return 1 + 64 * (channel - 1); }

// CiA 301
inline constexpr Object kDeviceType{0x1000};
inline constexpr Object kErrorRegister{0x1001};
inline constexpr Object kSyncIdentifier{0x1005};
inline constexpr Object kCyclePeriod{0x1006};  ///< us between two SYNCs
inline constexpr Object kDeviceName{0x1008};
inline constexpr Object kConsumerHeartbeat{0x1016, 1};
inline constexpr Object kProducerHeartbeat{0x1017};
inline constexpr Object kVendor{0x1018, 1};
inline constexpr Object kProduct{0x1018, 2};
inline constexpr Object kRevision{0x1018, 3};
inline constexpr Object kSerialNumber{0x1018, 4};
inline constexpr std::uint16_t kReceivePdoParameters = 0x1400;  ///< + number - 1
inline constexpr std::uint16_t kReceivePdoMapping = 0x1600;
inline constexpr std::uint16_t kTransmitPdoParameters = 0x1800;
inline constexpr std::uint16_t kTransmitPdoMapping = 0x1a00;

// CiA 402-2
inline constexpr Object kAbortConnectionOption{0x6007};
inline constexpr Object kErrorCode{0x603f};
inline constexpr Object kControlword{0x6040};
inline constexpr Object kStatusword{0x6041};
inline constexpr Object kQuickStopOption{0x605a};
inline constexpr Object kFaultReactionOption{0x605e};
inline constexpr Object kMode{0x6060};
inline constexpr Object kModeDisplay{0x6061};
inline constexpr Object kPositionActual{0x6064};
inline constexpr Object kFollowingErrorWindow{0x6065};
inline constexpr Object kVelocityActual{0x606c};
inline constexpr Object kTargetTorque{0x6071};
inline constexpr Object kRatedCurrent{0x6075};  ///< mA
inline constexpr Object kRatedTorque{0x6076};
inline constexpr Object kTorqueActual{0x6077};  ///< per mille of the rated torque
inline constexpr Object kTargetPosition{0x607a};
inline constexpr Object kHomeOffset{0x607c};
inline constexpr Object kHomingMethod{0x6098};
inline constexpr Object kHomingSpeedSwitch{0x6099, 1};
inline constexpr Object kHomingSpeedZero{0x6099, 2};
inline constexpr Object kHomingAcceleration{0x609a};
inline constexpr Object kInterpolationTime{0x60c2, 1};      ///< of the cyclic modes' set-points
inline constexpr Object kInterpolationExponent{0x60c2, 2};  ///< of ten: 60C2:1 x 10^60C2:2 s
inline constexpr Object kDigitalInputs{0x60fd};
inline constexpr Object kDigitalOutputs{0x60fe, 1};
inline constexpr Object kTargetVelocity{0x60ff};
inline constexpr Object kSupportedModes{0x6502};  ///< bit n: mode n + 1 is supported

// CiA 401: index of each array, whose parts 1, 2, ... are blocks of 8 digital terminals or single analogue ones
inline constexpr std::uint16_t kReadInputs = 0x6000;
inline constexpr std::uint16_t kWriteOutputs = 0x6200;
inline constexpr std::uint16_t kOutputErrorMode = 0x6206;   ///< bit 1: the output takes its error value
inline constexpr std::uint16_t kOutputErrorValue = 0x6207;  ///< when the node fails, is stopped or loses its master
inline constexpr std::uint16_t kReadAnalogInputs = 0x6401;  ///< 16 bits, 32767 is the end of the range
inline constexpr std::uint16_t kWriteAnalogOutputs = 0x6411;
inline constexpr std::uint16_t kAnalogOutputErrorMode = 0x6443;   ///< 1: the output takes its error value
inline constexpr std::uint16_t kAnalogOutputErrorValue = 0x6444;  ///< 32 bits
inline constexpr Object kAnalogInterruptEnable{0x6423};           ///< without it some nodes send no analogue inputs

/// Bits of 60FDh.
inline constexpr std::uint32_t kNegativeLimitSwitch = 1u << 0;
inline constexpr std::uint32_t kPositiveLimitSwitch = 1u << 1;
inline constexpr std::uint32_t kHomeSwitch = 1u << 2;

}  // namespace mrroc::canopen
