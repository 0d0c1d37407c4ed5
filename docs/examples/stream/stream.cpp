#include "stream.hpp"

static std::unique_ptr<mrroc::edp::Hardware> make(const mrroc::edp::DriverContext& context) {
  return std::make_unique<mrroc::Stream>(context);
}
MRROC_DRIVER(make)
