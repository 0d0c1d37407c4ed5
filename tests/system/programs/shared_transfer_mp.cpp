#include "system/programs/shared_transfer.hpp"

namespace mrroc::test {
namespace {

struct BySixAxes : SharedTransfer<Irb6> {
  BySixAxes() : SharedTransfer(transfer::kSixAxes) {}
};

}  // namespace
}  // namespace mrroc::test

MRROC_MP(mrroc::test::BySixAxes)
