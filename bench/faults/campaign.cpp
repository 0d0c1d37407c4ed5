#include "faults/campaign.hpp"

#include <algorithm>

#include "mrroc/testing/motion.hpp"

namespace mrroc::faults_bench {

const std::vector<Campaign>& campaigns() {
  static const std::vector<Campaign> all{
      {"press",
       MRROC_SOURCE_DIR "/tasks/press/press.toml",
       {"kill mp",
        "kill ecp:arm",
        "kill edp:arm",
        "kill vsp:wrist",
        "kill vsp:gate",
        "kill sim",
        "halt mp",
        "halt ecp:arm",
        "halt edp:arm",
        "halt vsp:wrist",
        "halt sim",
        "end ecp:arm",
        "end edp:arm",
        "fault edp:arm",
        "silence edp:arm",
        "unreference edp:arm",
        "jump edp:arm axis 2 by 3",
        "freeze edp:arm axis 2",
        "freeze edp:arm axis 4",
        "freeze edp:arm axis 5",
        "nan edp:arm axis 2",
        "overload edp:arm axis 2",
        "disconnect edp:arm axis 2",
        "runaway edp:arm axis 2",
        "silence vsp:wrist",
        "jump vsp:wrist by 200",
        "nan vsp:wrist",
        "lose ecp:arm",
        "delay ecp:arm by 40 for 100 ticks",
        "corrupt ecp:arm",
        "leap ecp:arm"}},
      {"cooperative_transfer",
       MRROC_SOURCE_DIR "/tasks/cooperative_transfer/cooperative_transfer.toml",
       {"kill mp",
        "kill ecp:left",
        "kill edp:left",
        "kill vsp:left_wrist",
        "kill sim",
        "halt mp",
        "halt ecp:left",
        "halt edp:left",
        "halt sim",
        "end ecp:left",
        "fault edp:left",
        "silence edp:left",
        "unreference edp:left",
        "jump edp:left axis 2 by 3",
        "freeze edp:left axis 2",
        "freeze edp:left axis 4",
        "freeze edp:left axis 5",
        "nan edp:left axis 2",
        "overload edp:left axis 2",
        "disconnect edp:left axis 2",
        "runaway edp:left axis 2",
        "silence vsp:left_wrist",
        "jump vsp:left_wrist by 200",
        "lose mp",
        "corrupt mp",
        "leap mp"}},
      {"recovering",
       MRROC_BINARY_DIR "/bench/recovering.toml",
       {"fault edp:arm for 200 ticks", "silence edp:arm for 200 ticks", "unreference edp:arm for 200 ticks",
        "jump edp:arm axis 2 by 3 for 200 ticks", "freeze edp:arm axis 2 for 300 ticks",
        "nan edp:arm axis 2 for 200 ticks", "overload edp:arm axis 2 for 1200 ticks",
        "disconnect edp:arm axis 2 for 500 ticks", "runaway edp:arm axis 2 for 50 ticks",
        "delay ecp:arm by 40 for 100 ticks", "corrupt ecp:arm for 100 ticks", "leap ecp:arm for 100 ticks"},
       true,
       true},
      // tests/can/with_can -- build/bench/faults 20 press_can
      {"press_can",
       MRROC_SOURCE_DIR "/tasks/press/press_can.toml",
       {"kill edp:arm", "kill drives:arm", "halt edp:arm", "halt drives:arm", "fault drives:arm axis 2",
        "silence drives:arm axis 2", "freeze drives:arm axis 2", "restart drives:arm axis 2", "hush drives:arm axis 2",
        "press drives:arm axis 2", "corrupt drives:arm axis 2"},
       false},
      // tests/can/with_can -- build/bench/faults 20 recovering_can
      {"recovering_can",
       MRROC_BINARY_DIR "/bench/recovering_can.toml",
       {"fault drives:arm axis 2 for 200 ticks", "silence drives:arm axis 2 for 200 ticks",
        "freeze drives:arm axis 2 for 600 ticks", "restart drives:arm axis 2 for 1 ticks",
        "hush drives:arm axis 2 for 300 ticks", "press drives:arm axis 2 for 200 ticks",
        "corrupt drives:arm axis 2 for 200 ticks"},
       false,
       true},
  };
  return all;
}

double speed_tolerance(const std::string& fault) {
  const std::vector<std::string> disobedient{"freeze edp", "disconnect edp", "runaway edp"};
  const bool obeys = std::none_of(disobedient.begin(), disobedient.end(),
                                  [&](const std::string& beginning) { return fault.starts_with(beginning); });
  return obeys ? task_test::kOvershoot : task_test::kDisobedience;
}

}  // namespace mrroc::faults_bench
