// An MP and the programs of the ECPs that it has started: an error during its own Move, and the stop of one of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "system/mrroc_run.hpp"

namespace mrroc::test::superior_test {
namespace {

TEST(Superior, ReceivesAnEcpErrorOnceDuringItsOwnMoveAndCanStopAnother) {
  const ScratchFolder folder;
  const std::string program = "program = \"" MRROC_BINARY_DIR "/tests/",
                    belt = "type = \"conveyor\"\nhardware = \"loopback\"\n",
                    subordinate = belt + program + "subordinate_ecp\"\n";
  const auto file = folder.write(
      "superior.toml", "[deployment]\nname = \"superior\"\n[mp]\n" + program + "superior_mp\"\n" + "[robots.own]\n" +
                           belt + "[robots.steady]\n" + subordinate + "[robots.failing]\n" + subordinate);
  for (const std::string clock : {"lockstep", "real"}) {
    const std::string output = run_mrroc({"run", file.string(), "--quiet", "--clock", clock}, 1);
    std::size_t from = 0;
    for (const char* line : {"reported: non-fatal error: a joint ", "process failing, device failing",
                             "moved on to 0.050 m", "refused: ", "steady stopped at 0.00 m/s"}) {
      const std::size_t at = output.find(line, from);
      EXPECT_NE(at, std::string::npos) << line << " in\n" << output;
      from = at == std::string::npos ? from : at;
    }
    EXPECT_NE(output.find("stop: the deployment has no robot 'nobody'"), std::string::npos) << output;
  }
}

}  // namespace
}  // namespace mrroc::test::superior_test
