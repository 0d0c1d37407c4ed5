#include <algorithm>
#include <utility>

#include "cli/trace/mutations.hpp"

namespace mrroc::cli::trace {

namespace {

bool everywhere(std::size_t) { return true; }

/// Changes any line.
Mutation of_any_line(const char* name, std::function<void(Line&, Random&)> change) {
  return {name, [change](TraceSteps& trace, Random& random) {
            const auto place = pick_line(trace, random, everywhere);
            if (place) change(trace.line(*place), random);
            return place.has_value();
          }};
}

/// Changes one of several lines of an instruction. A value that occurs only once cannot be compared.
Mutation of_one_of_several(const char* name, std::function<void(Line&, Random&)> change) {
  return {name, [change](TraceSteps& trace, Random& random) {
            const auto place = pick_line(trace, random, [&trace](std::size_t i) {
              return line_before(trace, i) != kNoLine || line_behind(trace, i) != kNoLine;
            });
            if (place) change(trace.line(*place), random);
            return place.has_value();
          }};
}

bool drop(TraceSteps& trace, Random& random) {
  const auto place = pick_line(trace, random, everywhere);
  if (place) trace.items.erase(trace.items.begin() + static_cast<std::ptrdiff_t>(*place));
  return place.has_value();
}

bool duplicate(TraceSteps& trace, Random& random) {
  const auto place = pick_line(trace, random, everywhere);
  if (!place) return false;
  const Item copy = trace.items[*place];
  trace.items.insert(trace.items.begin() + static_cast<std::ptrdiff_t>(*place), copy);
  return true;
}

bool share_a_robot(const Line& a, const Line& b) {
  for (const RobotEntry& one : a.robots)
    for (const RobotEntry& other : b.robots)
      if (one.name == other.name) return true;
  return false;
}

/// Not the end of an instruction and the beginning of the next one with other robots, or without robots: a process may
/// run both at the same time.
bool swap(TraceSteps& trace, Random& random) {
  const auto place = pick_line(trace, random, [&trace](std::size_t i) {
    if (i + 1 >= trace.items.size() || !trace.is_line(i + 1)) return i + 1 < trace.items.size();
    const Line &first = trace.line(i), &second = trace.line(i + 1);
    return !first.ends() || first.process != second.process || share_a_robot(first, second);
  });
  if (place) std::swap(trace.items[*place], trace.items[*place + 1]);
  return place.has_value();
}

/// The lines of a whole instruction.
bool drop_instruction(TraceSteps& trace, Random& random) {
  const auto place = pick_line(trace, random, everywhere);
  if (!place) return false;
  const Line chosen = trace.line(*place);
  std::erase_if(trace.items, [&chosen](const Item& item) {
    const Line* line = std::get_if<Line>(&item);
    return line != nullptr && line->process == chosen.process && line->instruction == chosen.instruction;
  });
  return true;
}

/// All lines of a process repeated as those of another one: both command the same robots at the same ticks.
bool second_commander(TraceSteps& trace, Random& random) {
  const auto place = pick_line(trace, random, [&trace](std::size_t i) {
    const Line& line = trace.line(i);
    const std::size_t behind = line_behind(trace, i);
    return !line.ends() && !line.robots.empty() && behind != kNoLine && trace.line(behind).tick > line.tick;
  });
  if (!place) return false;
  const std::string process = trace.line(*place).process;
  std::vector<Item> items;
  for (const Item& item : trace.items) {
    items.push_back(item);
    if (const Line* line = std::get_if<Line>(&item); line != nullptr && line->process == process) {
      Line copy = *line;
      copy.process += "_twin";
      items.emplace_back(copy);
    }
    if (const ProcessEnd* end = std::get_if<ProcessEnd>(&item); end != nullptr && end->process == process) {
      ProcessEnd copy = *end;
      copy.process += "_twin";
      items.emplace_back(copy);
    }
  }
  trace.items = std::move(items);
  return true;
}

bool spoil_remark(TraceSteps& trace, Random& random) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < trace.items.size(); ++i)
    if (!trace.is_line(i)) ends.push_back(i);
  if (ends.empty()) return false;
  ProcessEnd& end = std::get<ProcessEnd>(trace.items[ends[pick(random, 0, ends.size() - 1)]]);
  if (pick(random, 0, 1) == 0)
    ++end.lines;
  else
    ++end.dropped;
  return true;
}

/// Not where an instruction was interrupted: that may be at a step, or between two.
bool change_step(TraceSteps& trace, Random& random) {
  const auto place = pick_line(trace, random, [&trace](std::size_t i) { return !trace.line(i).broken_off(); });
  if (place) trace.line(*place).step += pick(random, 1, 5);
  return place.has_value();
}

/// A line of another instruction or process.
void move_elsewhere(Line& line, Random& random) {
  if (pick(random, 0, 1) == 0)
    line.process += "2";
  else
    line.instruction += pick(random, 1, 3);
}

}  // namespace

std::vector<Mutation> mutations_of_lines() {
  return {{"drop a line", drop},
          {"duplicate a line", duplicate},
          {"swap two lines", swap},
          {"drop an instruction", drop_instruction},
          {"let a second process command the same robots", second_commander},
          {"spoil a end", spoil_remark},
          {"change the step", change_step},
          of_any_line("change process or instruction", move_elsewhere),
          of_any_line("change the line's tick", [](Line& line, Random& random) { line.tick += pick(random, 1, 30); }),
          of_one_of_several("make a Wait of a Move, a Move of a Wait",
                            [](Line& line, Random&) {
                              line.is_move = !line.is_move;
                              line.until.reset();
                            }),
          of_one_of_several("drop the condition's name, or invent one", [](Line& line, Random&) {
            if (line.until)
              line.until.reset();
            else if (line.is_move)
              line.until = "invented";
            else
              line.name += " and more";
          })};
}

}  // namespace mrroc::cli::trace
