#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include "repetitions.hpp"

namespace mrroc::fakes {

/// Checks `property` (a function that uses RC_ASSERT and `*generator`) on `cases` random cases, as part of the running
/// GoogleTest. The seed is fixed and printed, so that every run checks the same cases; rapidcheck's own
/// RC_PARAMS="seed=7" selects others. All cases are also checked with a sanitizer, for tests that count over them.
template <class Property>
void check_every_case(int cases, Property&& property) {
  setenv("RC_PARAMS", "seed=20240229", 0);
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = cases;
  rc::detail::TestMetadata metadata;
  metadata.id = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const rc::detail::TestResult result =
      rc::detail::checkProperty(rc::detail::toProperty(std::forward<Property>(property)), metadata, params);
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  std::cout << "seed " << params.seed << ": " << text.str() << "\n";
  if (!result.template is<rc::detail::SuccessResult>()) ADD_FAILURE() << "RC_PARAMS=\"seed=" << params.seed << "\"";
}

/// The same, with fewer cases under a sanitizer (`repetitions`).
template <class Property>
void check_property(int cases, Property&& property) {
  check_every_case(test::repetitions(cases), std::forward<Property>(property));
}

}  // namespace mrroc::fakes
