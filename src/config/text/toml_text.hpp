#pragma once

#include <string>

#include "config/text/toml_parser.hpp"

namespace mrroc::config {

/// `root` as the text of a TOML file, its keys in the order in which they were written. Comments are lost.
/// Configuration time only.
std::string toml_text(const toml::table& root);

}  // namespace mrroc::config
