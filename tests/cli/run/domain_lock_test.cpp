#include "cli/run/domain_lock.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mrroc::cli::domain_lock_test {
namespace {

TEST(DomainLock, TwoDeploymentsGetTwoDomains) {
  const DomainLock first(-1);
  const DomainLock second(-1);
  EXPECT_NE(first.domain(), second.domain());
}

TEST(DomainLock, TheDomainOfRos2IsAvoided) {
  int next = -1;
  {
    const DomainLock free(-1);
    next = free.domain();
  }
  EXPECT_NE(DomainLock(-1, next).domain(), next);
  EXPECT_THROW(DomainLock(next, next), std::runtime_error);
  EXPECT_EQ(DomainLock(next, next + 1).domain(), next);
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
}  // namespace mrroc::cli::domain_lock_test
