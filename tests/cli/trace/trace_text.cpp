#include "cli/trace/trace_text.hpp"

#include <unistd.h>

#include <fstream>

#include "cli/output/trace.hpp"
#include "cli/trace/format_line.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::trace {

std::string TraceText::text() const {
  std::string all = std::string{kTraceHeader} + clock + "\n";
  for (const Item& item : items) {
    const Line* line = std::get_if<Line>(&item);
    all += (line != nullptr ? format_line(*line) : format_remark(std::get<Remark>(item))) + "\n";
  }
  return all;
}

TraceText read_trace(const std::filesystem::path& file) {
  TraceText trace;
  Reader reader(file);
  trace.clock = reader.simulated() ? "lockstep" : "real";
  for (;;) {
    const auto item = reader.next();
    if (const Line* line = std::get_if<Line>(&item))
      trace.items.emplace_back(*line);
    else if (const Remark* remark = std::get_if<Remark>(&item))
      trace.items.emplace_back(*remark);
    else
      return trace;
  }
}

std::size_t line_count(const TraceText& whole, const std::string& process) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < whole.items.size(); ++i)
    count += whole.is_line(i) && whole.line(i).process == process ? 1 : 0;
  return count;
}

TraceText black_box_of(const TraceText& whole, const std::string& process, std::size_t begin, std::size_t end) {
  TraceText box;
  box.clock = whole.clock + " black_box";
  std::size_t number = 0;
  for (std::size_t i = 0; i < whole.items.size(); ++i) {
    if (!whole.is_line(i) || whole.line(i).process != process) continue;
    if (number >= begin && number < end) box.items.push_back(whole.items[i]);
    ++number;
  }
  Remark remark;
  remark.process = process;
  remark.lines = box.items.size();
  box.items.emplace_back(remark);
  return box;
}

std::string Found::text() const {
  std::string all = malformed;
  for (const std::string& violation : violations) all += violation + "\n";
  for (const std::string& note : verdict.notes) all += note + "\n";
  return all;
}

Found check_text(const std::string& text) {
  const task_test::ScratchFolder folder;
  const std::filesystem::path file = folder.write("checked.trace", text);
  Found found;
  try {
    found.verdict = check_trace(file, [&found](const std::string& violation) {
      found.violations.push_back(violation);
      const std::size_t begin = violation.find(": ") + 2;
      found.rules.insert(violation.substr(begin, violation.find(": ", begin) - begin));
    });
  } catch (const std::runtime_error& error) {
    found.malformed = error.what();
  }
  return found;
}

}  // namespace mrroc::cli::trace
