#include "config/entries/answers.hpp"

namespace mrroc::config {

std::vector<Answer> read_answers(const Table& root, const Deployment& deployment) {
  std::vector<std::string> processes{"mp"};
  for (const RobotEntry& robot : deployment.robots) processes.push_back(robot.name);
  std::vector<Answer> answers;
  for (const Table& table : root.tables("answers")) {
    table.only({"question", "answer", "process"});
    Answer answer{table.text("question"), "", table.text("answer"), table.line("answer")};
    if (table.has("process")) answer.process = table.choice("process", processes);
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace mrroc::config
