#pragma once

#include <string>

#include "mrroc/errors.hpp"
#include "mrroc/message.hpp"

namespace mrroc::vsp {

/// Passes a task's configuration (`Sensor::configure`) as its own type to `apply`, which takes each of `Known`:
///
///     void reconfigure(const Message& m) override {
///       take_configuration<Carrying, LowPassAt>(m, [this](const auto& configuration) { apply(configuration); });
///     }
///
/// Throws NonFatalError(invalid_argument) that lists the known types when it is of another one, and what `apply`
/// throws. The VSP's thread.
template <MessageType... Known, class Apply>
void take_configuration(const Message& message, Apply&& apply) {
  const bool taken =
      ((message.fingerprint == detail::fingerprint_of<Known>() && (apply(unpack<Known>(message)), true)) || ...);
  if (taken) return;
  std::string names;
  ((names.append(names.empty() ? "" : ", ").append(label_of<Known>())), ...);
  throw NonFatalError(
      ErrorCode::invalid_argument,
      std::string("configuration '").append(message.label.view()).append("', expected one of: ").append(names));
}

/// Throws NonFatalError(invalid_argument): "Carrying: <what> <value>, expected <expected>".
[[noreturn]] void refuse_configuration(std::string_view label, const std::string& what, double value,
                                       const std::string& expected);

/// The same unless `value` is finite and within `least` and `most`.
void check_configured(std::string_view label, const std::string& what, double value, double least, double most,
                      const std::string& unit);

}  // namespace mrroc::vsp
