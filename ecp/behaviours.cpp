#include "mrroc/behaviours.hpp"

#include <algorithm>

#include "mrroc/errors.hpp"

namespace mrroc::ecp {

namespace {

/// Filled before main, by one thread.
config::ProgramBehaviours& entered() {
  static config::ProgramBehaviours behaviours;
  return behaviours;
}

}  // namespace

bool detail::enter_on(MessageSchema schema) {
  entered().on.push_back(std::move(schema));
  return true;
}

bool detail::enter_tells(std::string_view label) {
  entered().tells.emplace_back(label);
  return true;
}

config::ProgramBehaviours Behaviours::declared() {
  config::ProgramBehaviours behaviours = entered();
  std::sort(behaviours.on.begin(), behaviours.on.end(),
            [](const MessageSchema& a, const MessageSchema& b) { return a.label < b.label; });
  std::sort(behaviours.tells.begin(), behaviours.tells.end());
  return behaviours;
}

void Behaviours::run(const Message& parcel) const {
  const auto found = handlers_.find(std::string{parcel.label.view()});
  if (found != handlers_.end()) {
    found->second(parcel);
    return;
  }
  std::string known;
  for (const auto& [label, handler] : handlers_) known += (known.empty() ? "" : ", ") + label;
  throw NonFatalError(ErrorCode::invalid_argument, "no behaviour '" + std::string{parcel.label.view()} +
                                                       "', there is " + (known.empty() ? "none" : known));
}

}  // namespace mrroc::ecp
