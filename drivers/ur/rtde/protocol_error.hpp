#pragma once

#include <stdexcept>

namespace mrroc::ur::rtde {

/// A package that does not have the form of the RTDE guide.
class ProtocolError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mrroc::ur::rtde
