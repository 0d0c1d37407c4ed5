#include "mrroc/robots/irb6.hpp"
#include "system/programs/sharing_arm.hpp"

namespace mrroc::test {
namespace {

struct Arm : SharingArm<Irb6> {
  Arm() : SharingArm(transfer::kSixAxes) {}
};

}  // namespace
}  // namespace mrroc::test

MRROC_ECP(mrroc::test::Arm)
