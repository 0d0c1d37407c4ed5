#include "mrroc/generator.hpp"

namespace mrroc {

void Generator::add_condition(std::shared_ptr<Condition> condition) {
  condition_ = condition_ ? std::make_shared<Either>(condition_, std::move(condition)) : std::move(condition);
}

}  // namespace mrroc
