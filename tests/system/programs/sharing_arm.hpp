#pragma once

#include "cooperative_transfer/transfer_path.hpp"
#include "mrroc/ecp.hpp"
#include "system/programs/share.hpp"

namespace mrroc::test {

/// An arm of the transfer by two arms, equation (11): c_0 from the MP, compliance here.
template <class Robot>
class SharingArm : public ecp::Task {
 public:
  explicit SharingArm(const transfer::Arms& arms) {
    on<Share>([this, arms](const Share& share) {
      Compliance compliance;
      const double tool = 2.04, half = share.mass / 2;  // kg
      compliance.load.mass = tool + half;
      compliance.load.centre = tool / (tool + half) * Eigen::Vector3d(0.0022, 0.0021, arms.tool_centre - arms.grip);
      const double tilt = arms.tilt ? 1e-3 : 0;
      compliance.admittance << 6e-5, 6e-5, 6e-5, tilt, tilt, 1e-3;
      Complying complying{superior(), arm_, compliance};
      complying.stay();
      Move({arm_}, {}, complying);
    });
  }

 private:
  Robot arm_{*this};
};

}  // namespace mrroc::test
