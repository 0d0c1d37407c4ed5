#include "config/entries/program_behaviours.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mrroc::config::program_behaviours_test {
namespace {

bool refused(const std::string& text) {
  try {
    read_behaviours(text);
    return false;
  } catch (const std::runtime_error&) {
    return true;
  }
}

TEST(ProgramBehaviours, RoundTrip) {
  const std::string text =
      "on Pick x:number:8 n:integer:8 b:truth:1 t:text:32 v:vector:24 j:joints:65 p:pose:96\non Rest\ntells Arrived\n";
  EXPECT_EQ(to_text(read_behaviours(text)), text);
}

TEST(ProgramBehaviours, FieldWithAnInvalidSizeIsRefused) {
  for (const char* field : {"x:number:4", "x:integer:0", "x:truth:8", "x:text:0", "x:vector:0", "x:vector:7",
                            "x:vector:12", "x:joints:64", "x:pose:95", "x:number:99999999999999999999999"})
    EXPECT_TRUE(refused(std::string{"on Pick "} + field)) << field;
}

TEST(ProgramBehaviours, FieldsLargerThanAMessageAreRefused) {
  EXPECT_FALSE(refused("on Pick a:text:500 b:number:8"));
  EXPECT_FALSE(refused("on Pick a:text:512"));
  EXPECT_TRUE(refused("on Pick a:text:513"));
  EXPECT_TRUE(refused("on Pick a:text:505 b:number:8"));
  EXPECT_TRUE(refused("on Pick a:text:18446744073709551615 b:number:8"));
}

}  // namespace
}  // namespace mrroc::config::program_behaviours_test
