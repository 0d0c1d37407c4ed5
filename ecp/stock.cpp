#include "mrroc/ecp.hpp"

namespace {

/// The stock ECP: transparent. A start does nothing; MP-level Moves pass through it.
class Stock : public mrroc::ecp::Task {};

}  // namespace

MRROC_ECP(Stock)
