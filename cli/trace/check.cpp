#include "cli/trace/check.hpp"

#include <algorithm>
#include <utility>

#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

constexpr std::size_t kDeferred = 100;  // kept violations of a process that its end may explain

class Check {
 public:
  Check(const std::filesystem::path& file, const std::function<void(const std::string&)>& report)
      : name_(file.filename().string()), reader_(file), report_(report), rules_(all_rules()) {
    memory_.simulated = reader_.simulated();
    memory_.black_box = reader_.black_box();
    verdict_.rules = rules_.size();
  }

  Verdict run() {
    for (;;) {
      const auto item = reader_.next();
      if (const auto* line = std::get_if<Line>(&item)) {
        check(*line);
      } else if (const auto* end = std::get_if<ProcessEnd>(&item)) {
        check(*end);
      } else {
        finish();
        return verdict_;
      }
    }
  }

 private:
  void check(const Line& line) {
    std::vector<Violation> found;
    if (!line.cut) {
      const Step step{line, memory_.before(line), memory_.instruction(line), memory_.process(line.process), memory_};
      for (const Rule& rule : rules_) {
        Findings findings(rule, line.number, found);
        if (rule.check != nullptr) rule.check(step, findings);
      }
    }
    memory_.take(line);
    settle(found, line.process);
  }

  void check(const ProcessEnd& end) {
    std::vector<Violation> found;
    for (const Rule& rule : rules_) {
      Findings findings(rule, end.number, found);
      if (rule.check_end != nullptr) rule.check_end(end, memory_, findings);
    }
    memory_.take(end);
    settle(found, end.process);
    if (end.dropped != 0) {
      note(end.number,
           words("process ", end.process, " has dropped ", end.dropped, " steps: missing ones are not a violation"));
      deferred_.erase(end.process);
    }
    if (end.cut != 0)
      note(end.number, words(end.cut, " steps of process ", end.process, " were too long and not checked"));
    tell_deferred(end.process);
  }

  /// A process without a end was killed, and its trace with it.
  void finish() {
    for (const auto& [name, process] : memory_.processes) {
      tell_deferred(name);
      if (process.lines != 0) ++verdict_.processes;
      if (process.ended) continue;
      std::string text = words("the steps of process ", name, " stop here: it was killed");
      for (const auto& open : process.open) text += words(", in instruction ", open.first);
      note(process.last_line, text);
    }
    verdict_.lines = memory_.lines;
    verdict_.instructions = memory_.instructions;
    verdict_.complete = reader_.complete();
  }

  void settle(const std::vector<Violation>& found, const std::string& process) {
    for (const Violation& violation : found) {
      std::vector<Violation>& deferred = deferred_[process];
      if (!violation.may_be_dropped || memory_.simulated)
        tell(violation);
      else if (deferred.size() < kDeferred)
        deferred.push_back(violation);
    }
  }

  void tell_deferred(const std::string& process) {
    for (const Violation& violation : deferred_[process]) tell(violation);
    deferred_.erase(process);
  }

  void tell(const Violation& violation) {
    ++verdict_.violations;
    report_(words(name_, ":", violation.line, ": ", violation.rule->name, ": ", violation.found, ", expected ",
                  violation.expected));
  }

  void note(std::size_t line, const std::string& text) {
    verdict_.notes.push_back(words(name_, ":", line, ": note: ", text));
  }

  std::string name_;
  Reader reader_;
  const std::function<void(const std::string&)>& report_;
  const Rules rules_;
  Memory memory_;
  std::map<std::string, std::vector<Violation>> deferred_;  ///< by process: its end decides whether they count
  Verdict verdict_;
};

}  // namespace

Verdict check_trace(const std::filesystem::path& file, const std::function<void(const std::string&)>& report) {
  return Check(file, report).run();
}

std::string text_of_rules() {
  std::string text;
  const auto column = [](std::string_view word, std::size_t width) {
    std::string padded{word};
    padded.resize(std::max(width, word.size() + 1), ' ');
    return padded;
  };
  for (const Rule& rule : all_rules()) text += column(rule.name, 24) + column(rule.equation, 30) + rule.says + "\n";
  return text;
}

}  // namespace mrroc::cli::trace
