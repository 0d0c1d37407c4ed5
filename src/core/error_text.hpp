#pragma once

#include <string>

#include "mrroc/errors.hpp"

namespace mrroc {

/// One sentence about an error, the same wherever it is printed: "class: code: detail [process p, device d, step s,
/// tick t]". Unknown parts of the origin are omitted. Any thread; allocates.
std::string error_text(ErrorClass error_class, ErrorCode code, const std::string& detail, const ErrorOrigin& origin);

}  // namespace mrroc
