#include "canopen/drive_words.hpp"

#include "canopen/objects.hpp"

namespace mrroc::canopen {

namespace {

constexpr std::uint16_t kHalt = 1u << 8;
constexpr std::uint16_t kWarning = 1u << 7;

/// The commands of the device control state machine (CiA 402-2, table of the controlword's command coding).
std::string command_text(std::uint16_t controlword) {
  if ((controlword & kFaultReset) != 0) return "fault reset";
  if ((controlword & 0x02) == 0) return "disable voltage";
  if ((controlword & 0x04) == 0) return "quick stop";
  if ((controlword & 0x01) == 0) return "shutdown";
  return (controlword & 0x08) != 0 ? "enable operation" : "switch on";
}

}  // namespace

std::string controlword_text(std::uint16_t controlword, DriveMode mode) {
  std::string text = command_text(controlword);
  if (mode == DriveMode::homing && (controlword & kStartHoming) != 0) text += ", start homing";
  if ((controlword & kHalt) != 0) text += ", halt";
  return text;
}

std::string statusword_text(std::uint16_t statusword, DriveMode mode) {
  std::string text(describe(drive_state(statusword)));
  const bool homes = mode == DriveMode::homing;
  if ((statusword & kWarning) != 0) text += ", warning";
  if ((statusword & kTargetReached) != 0) text += ", target reached";
  if ((statusword & kInternalLimit) != 0) text += ", internal limit";
  if ((statusword & kFollowsCommand) != 0) text += homes ? ", homing attained" : ", follows command";
  if ((statusword & kHomingError) != 0 && homes) text += ", homing error";
  if ((statusword & kFollowingError) != 0 && mode == DriveMode::cyclic_position) text += ", following error";
  return text;
}

std::string switches_text(std::uint32_t inputs) {
  std::string text;
  const auto add = [&text](const char* name) { text.append(text.empty() ? "" : ", ").append(name); };
  if ((inputs & kNegativeLimitSwitch) != 0) add("negative limit switch");
  if ((inputs & kPositiveLimitSwitch) != 0) add("positive limit switch");
  if ((inputs & kHomeSwitch) != 0) add("home switch");
  return text.empty() ? "no switch" : text;
}

}  // namespace mrroc::canopen
