#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::links {

/// Code of the SystemError that `action` throws, whose text must contain `part`; none: it throws none.
inline ErrorCode code_of(const std::function<void()>& action, const std::string& part) {
  try {
    action();
  } catch (const SystemError& error) {
    EXPECT_NE(error.detail().find(part), std::string::npos) << error.detail();
    return error.code();
  }
  return ErrorCode::none;
}

}  // namespace mrroc::links
