#include "language/instruction_lists.hpp"

#include <algorithm>

namespace mrroc {

namespace {

template <class Element>
void refuse_duplicates(const std::vector<Element*>& elements, const Task& task) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::size_t j = i + 1; j < elements.size(); ++j) {
      if (elements[i]->name() == elements[j]->name()) {
        throw NonFatalError(ErrorCode::invalid_argument, "'" + elements[i]->name() + "' is listed twice",
                            {task.process_name(), elements[i]->name(), 0, 0});
      }
    }
  }
}

}  // namespace

Task& task_of(const std::vector<Robot*>& robots, const std::vector<Sensor*>& sensors) {
  if (robots.empty() && sensors.empty()) {
    throw NonFatalError(ErrorCode::invalid_argument, "Move and Wait need at least one robot or sensor");
  }
  const auto missing = [](const auto* element) { return element == nullptr; };
  if (std::any_of(robots.begin(), robots.end(), missing) || std::any_of(sensors.begin(), sensors.end(), missing)) {
    throw NonFatalError(ErrorCode::invalid_argument, "a robot or sensor of the list is a null pointer");
  }
  Task& task = !robots.empty() ? robots.front()->task() : sensors.front()->task();
  const auto foreign = [&task](const auto* element) { return &element->task() != &task; };
  if (std::any_of(robots.begin(), robots.end(), foreign) || std::any_of(sensors.begin(), sensors.end(), foreign)) {
    throw NonFatalError(ErrorCode::invalid_argument, "robots and sensors of one instruction belong to different tasks",
                        {task.process_name(), "", 0, 0});
  }
  refuse_duplicates(robots, task);
  refuse_duplicates(sensors, task);
  return task;
}

ExclusiveUse::ExclusiveUse(const std::vector<Robot*>& robots, const std::vector<Sensor*>& sensors)
    : robots_(robots), sensors_(sensors) {
  try {
    for (Robot* robot : robots_) {
      robot->acquire();
      ++acquired_;
    }
    for (Sensor* sensor : sensors_) {
      sensor->acquire();
      ++acquired_;
    }
  } catch (...) {
    release();
    throw;
  }
}

void ExclusiveUse::release() noexcept {
  for (std::size_t i = 0; i < acquired_; ++i) {
    if (i < robots_.size())
      robots_[i]->release();
    else
      sensors_[i - robots_.size()]->release();
  }
}

}  // namespace mrroc
