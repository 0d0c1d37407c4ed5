#include "mrroc/outcome.hpp"

#include "mrroc/errors.hpp"

namespace mrroc {

bool Outcome::by(std::string_view name) const noexcept {
  for (const Condition* reason : reasons) {
    if (reason->name() == name) return true;
  }
  return false;
}

const Outcome& Outcome::require(std::string_view name, std::string_view otherwise) const {
  if (!by(name)) fail(otherwise);
  return *this;
}

void Outcome::fail(std::string_view otherwise) { throw NonFatalError{std::string{otherwise}}; }

std::string Outcome::reason() const {
  switch (ending) {
    case Ending::generator:
      return "generator";
    case Ending::end_motion:
      return "end of motion";
    case Ending::condition:
      break;
  }
  std::string text;
  for (const Condition* reason : reasons) {
    if (!text.empty()) text += " and ";
    text += reason->name();
  }
  return text;
}

}  // namespace mrroc
