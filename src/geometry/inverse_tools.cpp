#include "geometry/inverse_tools.hpp"

#include <cmath>

namespace mrroc {

double nearest_angle(double angle, double near, double period) noexcept {
  return near + std::remainder(angle - near, period);
}

}  // namespace mrroc
