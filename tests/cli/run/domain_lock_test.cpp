#include "cli/run/domain_lock.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mrroc::cli {
namespace {

TEST(DomainLock, TwoDeploymentsGetTwoDomains) {
  const DomainLock first(-1);
  const DomainLock second(-1);
  EXPECT_NE(first.domain(), second.domain());
}

TEST(DomainLock, ATakenDomainIsRefusedAndFreeAgainAfterwards) {
  int domain = 0;
  {
    const DomainLock first(-1);
    domain = first.domain();
    EXPECT_THROW(DomainLock{domain}, std::runtime_error);
  }
  const DomainLock again(domain);
  EXPECT_EQ(again.domain(), domain);
}

}  // namespace
}  // namespace mrroc::cli
