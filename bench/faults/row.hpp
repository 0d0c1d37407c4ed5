#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mrroc/testing/run.hpp"

namespace mrroc::faults_bench {

/// Results of the runs with one fault: a line of the table.
class Row {
 public:
  /// `fault`: without its time.
  explicit Row(std::string fault);

  /// Takes a run with the fault `injected`, its full text.
  void add(const task_test::RunResult& run, const std::string& injected);
  /// False: a robot exceeded a limit, moved to the end (except with a killed world) or was not recorded; a process
  /// remained; a run ended before its fault; or a run did not reach its end though its task `recovers`.
  bool good(bool recovers) const;
  void print() const;
  static void print_head();

 private:
  std::string fault_;
  std::vector<Tick> detected_;  ///< ticks from the fault to the first error, or to the end of the run that names it
  std::vector<Tick> standing_;  ///< ticks from then until every robot stands
  double fastest_ = 0;          ///< joint, as a part of its limit
  std::size_t runs_ = 0, unseen_ = 0, early_ = 0, exceeded_ = 0, moving_ = 0, leftovers_ = 0;
  std::size_t ended_ = 0, recovered_ = 0, unaffected_ = 0;
  std::map<std::string, std::size_t> places_;  ///< number of runs by the place where the error was thrown
  std::map<std::string, std::size_t> errors_;  ///< number of runs by kind of error
  std::set<int> exit_codes_;
};

}  // namespace mrroc::faults_bench
