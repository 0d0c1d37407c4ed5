#include "mrroc/ecp.hpp"

namespace {

/// The stock ECP: transparent. It has nothing to do when it is started; MP-level Moves pass through it.
class Stock : public mrroc::ecp::Task {};

}  // namespace

MRROC_ECP(Stock)
