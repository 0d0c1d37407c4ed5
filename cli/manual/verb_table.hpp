#pragma once

#include <string>

namespace mrroc::cli {

/// The operator's verbs as a Markdown table, for docs/reference/operator.md. Any thread.
std::string verb_table();

}  // namespace mrroc::cli
