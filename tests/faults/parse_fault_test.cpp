#include <gtest/gtest.h>

#include <stdexcept>

#include "faults/fault.hpp"

namespace mrroc::faults {
namespace {

TEST(ParseFault, ProcessAtItsOwnStep) {
  const InjectedFault fault = parse_fault("kill ecp:arm at step 120");
  EXPECT_EQ(fault.kind, Kind::kill);
  EXPECT_EQ(fault.process, "arm");
  EXPECT_TRUE(fault.at_step);
  EXPECT_EQ(fault.when, 120U);
  EXPECT_EQ(fault.counter, "arm");
  EXPECT_EQ(fault.duration, kNever);
  EXPECT_EQ(fault.text, "kill ecp:arm at step 120");
}

TEST(ParseFault, AxisByAValueForSomeTime) {
  const InjectedFault fault = parse_fault("jump edp:arm axis 2 by -0.5 at tick 800 for 30 ticks");
  EXPECT_EQ(fault.kind, Kind::jump);
  EXPECT_EQ(fault.process, "arm_edp");
  EXPECT_EQ(fault.axis, 1U);
  EXPECT_EQ(fault.value, -0.5);
  EXPECT_FALSE(fault.at_step);
  EXPECT_EQ(fault.when, 800U);
  EXPECT_EQ(fault.duration, 30U);
}

TEST(ParseFault, StepOfAnotherProcess) {
  EXPECT_EQ(parse_fault("halt edp:arm at step 5").counter, "arm");
  EXPECT_EQ(parse_fault("halt edp:arm at step 5 of mp").counter, "mp");
  EXPECT_EQ(parse_fault("kill sim at step 5 of arm").counter, "arm");
  EXPECT_EQ(parse_fault("nan vsp:wrist at step 5 of mp").process, "wrist");
}

TEST(ParseFault, OneDriveOnABus) {
  for (const auto& [word, kind] : {std::pair{"fault", Kind::fault},
                                   {"silence", Kind::silence},
                                   {"freeze", Kind::freeze},
                                   {"restart", Kind::restart},
                                   {"hush", Kind::hush},
                                   {"press", Kind::press},
                                   {"corrupt", Kind::corrupt}}) {
    const InjectedFault fault = parse_fault(std::string{word} + " drives:arm axis 3 at step 40 for 5 ticks");
    EXPECT_EQ(fault.kind, kind);
    EXPECT_EQ(fault.process, "arm_drives");
    EXPECT_EQ(fault.axis, 2U);
    EXPECT_EQ(fault.counter, "arm");
    EXPECT_EQ(fault.duration, 5U);
  }
  EXPECT_EQ(parse_fault("fault edp:arm at tick 3").process, "arm_edp") << "all its drives";
  EXPECT_EQ(parse_fault("corrupt ecp:arm at tick 3").process, "arm") << "its commands";
}

TEST(ParseFault, OneIoNodeOnABus) {
  for (const auto& [word, kind] : {std::pair{"fault", Kind::fault},
                                   {"silence", Kind::silence},
                                   {"hush", Kind::hush},
                                   {"restart", Kind::restart}}) {
    const InjectedFault fault = parse_fault(std::string{word} + " io:arm node 40 at step 7 for 5 ticks");
    EXPECT_EQ(fault.kind, kind);
    EXPECT_EQ(fault.process, "arm_drives");
    EXPECT_EQ(fault.io, IoPart::node);
    EXPECT_EQ(fault.io_number, 40);
    EXPECT_EQ(fault.counter, "arm");
    EXPECT_EQ(fault.duration, 5U);
  }
  EXPECT_EQ(parse_fault("silence drives:arm axis 2 at tick 3").io, IoPart::none);
}

TEST(ParseFault, AnInputThatSticks) {
  const InjectedFault digital = parse_fault("stick io:arm input 15 to 1 at tick 20");
  EXPECT_EQ(digital.kind, Kind::stick);
  EXPECT_EQ(digital.process, "arm_drives");
  EXPECT_EQ(digital.io, IoPart::digital_input);
  EXPECT_EQ(digital.io_number, 15);
  EXPECT_EQ(digital.value, 1);
  EXPECT_EQ(digital.when, 20U);
  const InjectedFault analog = parse_fault("stick io:arm analog 0 to -2.5 at step 4 of mp for 9 ticks");
  EXPECT_EQ(analog.io, IoPart::analog_input);
  EXPECT_EQ(analog.io_number, 0);
  EXPECT_EQ(analog.value, -2.5);
  EXPECT_EQ(analog.counter, "mp");
  EXPECT_EQ(analog.duration, 9U);
}

TEST(ParseFault, ThreeKindsAreSignals) {
  for (const Kind kind : {Kind::kill, Kind::halt, Kind::end}) EXPECT_TRUE(is_signal(kind));
  for (const Kind kind : {Kind::fault, Kind::freeze, Kind::hush, Kind::lose}) EXPECT_FALSE(is_signal(kind));
}

/// An invalid text, and its error message.
struct Wrong {
  const char* text;
  const char* message;
};

class WrongFault : public testing::TestWithParam<Wrong> {};

TEST_P(WrongFault, IsRefusedWithTheWordAndTheExpectation) {
  try {
    parse_fault(GetParam().text);
    FAIL() << GetParam().text;
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string{error.what()}, "the fault \"" + std::string{GetParam().text} + "\": " + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Texts, WrongFault,
    testing::Values(
        Wrong{"",
              "it ends, expected one of kill, halt, end, fault, silence, unreference, jump, freeze, nan, overload, "
              "disconnect, runaway, restart, hush, press, stick, lose, delay, corrupt, leap"},
        Wrong{"kill arm at tick 1", "'arm', expected mp, sim, ecp:ROBOT, edp:ROBOT, drives:ROBOT or vsp:SENSOR"},
        Wrong{"kill ecp: at tick 1", "'ecp:', expected mp, sim, ecp:ROBOT, edp:ROBOT, drives:ROBOT or vsp:SENSOR"},
        Wrong{"fault ecp:arm at tick 1", "'ecp:arm', expected edp:ROBOT, drives:ROBOT or io:ROBOT"},
        Wrong{"fault drives:arm at tick 1", "'at', expected 'axis'"},
        Wrong{"restart edp:arm axis 1 at tick 1", "'edp:arm', expected drives:ROBOT or io:ROBOT"},
        Wrong{"nan drives:arm axis 1 at tick 1", "'drives:arm', expected edp:ROBOT or vsp:SENSOR"},
        Wrong{"kill mp:arm at tick 1", "'mp:arm', expected mp, sim, ecp:ROBOT, edp:ROBOT, drives:ROBOT or vsp:SENSOR"},
        Wrong{"lose edp:arm at tick 1", "'edp:arm', expected mp or ecp:ROBOT"},
        Wrong{"nan edp:arm at tick 1", "'at', expected 'axis'"},
        Wrong{"nan edp:arm axis 0 at tick 1", "'0', expected an axis from 1 to 8"},
        Wrong{"jump edp:arm axis 1 by far at tick 1", "'far', expected a number"},
        Wrong{"jump edp:arm axis 1 by inf at tick 1", "'inf', expected a number"},
        Wrong{"kill mp", "it ends, expected 'at'"}, Wrong{"kill mp at noon", "'noon', expected 'tick' or 'step'"},
        Wrong{"kill mp at tick -1", "'-1', expected a tick"},
        Wrong{"kill mp at step 0", "'0', expected a step, from 1"},
        Wrong{"kill sim at step 5", "it ends, expected 'of' and mp or a robot"},
        Wrong{"lose mp at tick 5 for 3", "it ends, expected 'ticks'"},
        Wrong{"lose mp at tick 5 for 0 ticks", "'0', expected a number of ticks, from 1"},
        Wrong{"halt mp at tick 5 for 3 ticks", "'for', expected nothing more"},
        Wrong{"delay mp by 1e30 at tick 5",
              "'1000000000000000019884624838656.000000', expected a delay of 1 to 1000000 ticks"},
        Wrong{"kill io:arm at tick 1", "'io:arm', expected mp, sim, ecp:ROBOT, edp:ROBOT, drives:ROBOT or vsp:SENSOR"},
        Wrong{"freeze io:arm node 40 at tick 1", "'io:arm', expected edp:ROBOT, drives:ROBOT or vsp:SENSOR"},
        Wrong{"silence io: node 40 at tick 1", "'io:', expected edp:ROBOT, drives:ROBOT, io:ROBOT or vsp:SENSOR"},
        Wrong{"silence io:arm at tick 1", "'at', expected 'node'"},
        Wrong{"silence io:arm axis 1 at tick 1", "'axis', expected 'node'"},
        Wrong{"restart io:arm node 0 at tick 1", "'0', expected a node from 1 to 127"},
        Wrong{"restart io:arm node 128 at tick 1", "'128', expected a node from 1 to 127"},
        Wrong{"stick drives:arm axis 1 at tick 1", "'drives:arm', expected io:ROBOT"},
        Wrong{"stick io:arm node 40 at tick 1", "'node', expected 'input' or 'analog'"},
        Wrong{"stick io:arm input 16 to 1 at tick 1", "'16', expected an input from 0 to 15"},
        Wrong{"stick io:arm analog 8 to 1 at tick 1", "'8', expected an input from 0 to 7"},
        Wrong{"stick io:arm input 3 at tick 1", "'at', expected 'to'"},
        Wrong{"stick io:arm input 3 to on at tick 1", "'on', expected a state from 0 to 1"},
        Wrong{"stick io:arm analog 3 to nan at tick 1", "'nan', expected a number"},
        Wrong{"kill mp at tick 5 please", "'please', expected nothing more"}));

}  // namespace
}  // namespace mrroc::faults
