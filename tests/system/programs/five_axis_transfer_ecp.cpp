#include "mrroc/robots/irb6_five_axis.hpp"
#include "system/programs/sharing_arm.hpp"

namespace mrroc::test {
namespace {

struct Arm : SharingArm<Irb6FiveAxis> {
  Arm() : SharingArm(transfer::kFiveAxes) {}
};

}  // namespace
}  // namespace mrroc::test

MRROC_ECP(mrroc::test::Arm)
