#include "mrroc/robots/irb6_five_axis.hpp"
#include "system/programs/shared_transfer.hpp"

namespace mrroc::test {
namespace {

struct ByFiveAxes : SharedTransfer<Irb6FiveAxis> {
  ByFiveAxes() : SharedTransfer(transfer::kFiveAxes) {}
};

}  // namespace
}  // namespace mrroc::test

MRROC_MP(mrroc::test::ByFiveAxes)
