#include "canopen/drive_state.hpp"

#include <gtest/gtest.h>

#include <array>

#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

using S = DriveState;

constexpr std::array kStates{S::not_ready_to_switch_on, S::switch_on_disabled, S::ready_to_switch_on,    S::switched_on,
                             S::operation_enabled,      S::quick_stop_active,  S::fault_reaction_active, S::fault};

TEST(DriveState, MatchesThePatternOfTheStatusword) {
  // CiA 402-2, "state coding": xxxx xxxx x0xx 0000 and so on; x is any value
  const std::array<std::pair<std::uint16_t, S>, 8> patterns{{{0x00, S::not_ready_to_switch_on},
                                                             {0x40, S::switch_on_disabled},
                                                             {0x21, S::ready_to_switch_on},
                                                             {0x23, S::switched_on},
                                                             {0x27, S::operation_enabled},
                                                             {0x07, S::quick_stop_active},
                                                             {0x0f, S::fault_reaction_active},
                                                             {0x08, S::fault}}};
  for (const auto& [bits, state] : patterns) {
    EXPECT_EQ(drive_state(bits), state);
    EXPECT_EQ(drive_state(static_cast<std::uint16_t>(bits | 0xff90)), state) << "the other bits have no effect";
  }
  EXPECT_EQ(drive_state(0x6f), S::not_ready_to_switch_on) << "bits of no state";
}

TEST(DriveState, GivesItsBits) {
  for (const S state : kStates) EXPECT_EQ(drive_state(status_bits(state)), state) << describe(state);
  for (const S state : {S::switched_on, S::operation_enabled, S::quick_stop_active, S::fault_reaction_active})
    EXPECT_NE(status_bits(state) & 0x10, 0) << describe(state) << ": voltage enabled";
  EXPECT_EQ(status_bits(S::switch_on_disabled) & 0x10, 0);
}

TEST(DriveState, FollowsEveryTransitionOfTheStandard) {
  struct Transition {
    int number;
    S from;
    std::uint16_t controlword;
    S to;
  };
  constexpr std::array transitions{Transition{2, S::switch_on_disabled, kShutdown, S::ready_to_switch_on},
                                   Transition{3, S::ready_to_switch_on, kSwitchOn, S::switched_on},
                                   Transition{4, S::switched_on, kEnableOperation, S::operation_enabled},
                                   Transition{5, S::operation_enabled, kSwitchOn, S::switched_on},
                                   Transition{6, S::switched_on, kShutdown, S::ready_to_switch_on},
                                   Transition{7, S::ready_to_switch_on, kQuickStop, S::switch_on_disabled},
                                   Transition{7, S::ready_to_switch_on, kDisableVoltage, S::switch_on_disabled},
                                   Transition{8, S::operation_enabled, kShutdown, S::ready_to_switch_on},
                                   Transition{9, S::operation_enabled, kDisableVoltage, S::switch_on_disabled},
                                   Transition{10, S::switched_on, kQuickStop, S::switch_on_disabled},
                                   Transition{10, S::switched_on, kDisableVoltage, S::switch_on_disabled},
                                   Transition{11, S::operation_enabled, kQuickStop, S::quick_stop_active},
                                   Transition{12, S::quick_stop_active, kDisableVoltage, S::switch_on_disabled},
                                   Transition{15, S::fault, kFaultReset, S::switch_on_disabled}};
  for (const Transition& each : transitions)
    EXPECT_EQ(commanded_state(each.from, each.controlword, 0), each.to) << "transition " << each.number;
}

TEST(DriveState, OtherCommandsDoNotChangeIt) {
  EXPECT_EQ(commanded_state(S::switch_on_disabled, kSwitchOn, 0), S::switch_on_disabled);
  EXPECT_EQ(commanded_state(S::switch_on_disabled, kEnableOperation, 0), S::switch_on_disabled);
  EXPECT_EQ(commanded_state(S::fault, kFaultReset, kFaultReset), S::fault) << "only at the rising edge";
  EXPECT_TRUE(rc::check("any controlword", [](std::uint16_t word, std::uint16_t before) {
    for (const S state : {S::not_ready_to_switch_on, S::fault_reaction_active})
      RC_ASSERT(commanded_state(state, word, before) == state);
    for (const S state : kStates) {
      const S now = commanded_state(state, word, before);
      RC_ASSERT(now == state || (now != S::fault && now != S::fault_reaction_active));
      if (now == S::operation_enabled) RC_ASSERT(state == S::switched_on || state == S::operation_enabled);
      if (now == S::quick_stop_active) RC_ASSERT(state == S::operation_enabled || state == S::quick_stop_active);
      if ((word & 2) == 0 && state != S::fault)
        RC_ASSERT(now == S::switch_on_disabled || now == S::not_ready_to_switch_on || now == S::fault_reaction_active);
    }
  }));
}

TEST(DriveState, ReachesOperationFromEveryStateButFaults) {
  for (S state :
       {S::switch_on_disabled, S::ready_to_switch_on, S::switched_on, S::operation_enabled, S::quick_stop_active}) {
    std::uint16_t before = 0;
    for (int i = 0; i < 4; ++i) {
      const std::uint16_t word = towards_operation(state);
      state = commanded_state(state, word, before);
      before = word;
    }
    EXPECT_EQ(state, S::operation_enabled);
  }
  for (const S state : {S::not_ready_to_switch_on, S::fault_reaction_active, S::fault})
    EXPECT_EQ(towards_operation(state), kDisableVoltage) << describe(state);
}

TEST(DriveState, HasNames) {
  EXPECT_EQ(describe(S::operation_enabled), "operation enabled");
  EXPECT_EQ(describe(static_cast<S>(99)), "unknown");
  EXPECT_EQ(describe(DriveMode::cyclic_torque), "cyclic synchronous torque");
  EXPECT_EQ(describe(static_cast<DriveMode>(3)), "another");
}

}  // namespace
}  // namespace mrroc::canopen
