#include "mrroc/sensors/operator_input.hpp"

#include <limits>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

OperatorInput::OperatorInput(Task& task, const std::string& name) : Sensor(task, name, "operator_input") {}

double OperatorInput::answer() const noexcept {
  return answered() ? value(1) : std::numeric_limits<double>::quiet_NaN();
}

double ask(OperatorInput& input) {
  input.ask();
  Wait({}, {input}, Answered{input});
  if (!input.answered()) {
    throw NonFatalError(ErrorCode::sensor_not_ready, "the operator has not answered",
                        {input.task().process_name(), input.name(), 0, input.reading().tick});
  }
  return input.answer();
}

}  // namespace mrroc
