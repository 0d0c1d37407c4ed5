#include "cli/trace/reader.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "cli/output/trace.hpp"
#include "cli/trace/parse_line.hpp"
#include "config/clock_names.hpp"
#include "core/text_lines.hpp"
#include "process/record/text_line.hpp"

namespace mrroc::cli::trace {

namespace {

Remark parse_remark(std::string_view text) {
  Fields fields(text);
  Remark remark;
  fields.expect("# process=", "remark");
  remark.process = fields.name("process");
  fields.expect(" lines=", "remark");
  remark.lines = fields.count("lines");
  fields.expect(" dropped=", "remark");
  remark.dropped = fields.count("dropped");
  fields.expect(" cut=", "remark");
  remark.cut = fields.count("cut");
  if (!fields.at_end()) throw Malformed("remark", text, "nothing behind 'cut'");
  return remark;
}

}  // namespace

Reader::Reader(std::filesystem::path file) : Reader(file, std::make_unique<std::ifstream>(file, std::ios::binary)) {}

Reader::Reader(std::filesystem::path name, std::string text)
    : Reader(std::move(name), std::make_unique<std::istringstream>(std::move(text))) {}

Reader::Reader(std::filesystem::path path, std::unique_ptr<std::istream> stream)
    : path_(std::move(path)), file_(std::move(stream)) {
  if (!*file_) throw std::runtime_error("cannot read the trace " + path_.string() + ": " + std::strerror(errno));
  const bool known = read() && text_.starts_with(kTraceHeader);
  std::string clock = known ? text_.substr(kTraceHeader.size()) : "";
  black_box_ = clock.ends_with(process::kBlackBoxMark);
  if (black_box_) clock.resize(clock.size() - process::kBlackBoxMark.size());
  simulated_ = clock != "real";
  if (!config::clock_named(clock))
    throw std::runtime_error(path_.string() + ":1: is not a trace, expected the line \"" + std::string{kTraceHeader} +
                             "...\", the clock real, paced or lockstep");
}

bool Reader::read() {
  if (!std::getline(*file_, text_)) {
    if (file_->bad()) throw std::runtime_error("cannot read the trace " + path_.string() + ": " + std::strerror(errno));
    return false;
  }
  ++number_;
  try {
    // the writer's own bound on the length is checked below
    constexpr std::size_t kAnyLength = std::numeric_limits<std::size_t>::max();
    const std::string_view content = core::content_of_line(text_, static_cast<int>(number_), kAnyLength);
    text_ = std::string(content.substr(0, content.find_last_not_of(" \t") + 1));
  } catch (const core::TextError& error) {
    throw std::runtime_error(path_.string() + ":" + std::to_string(number_) + ": " + error.what());
  }
  return true;
}

std::variant<std::monostate, Line, Remark> Reader::next() {
  if (!read()) return {};
  try {
    if (text_.size() > process::TextLine::kCapacity)
      throw Malformed("line", text_, "at most " + std::to_string(process::TextLine::kCapacity) + " characters");
    if (text_.starts_with('#')) {
      Remark remark = parse_remark(text_);
      remark.number = number_;
      return remark;
    }
    Line line = parse_line(text_, process::TextLine::kCapacity);
    line.number = number_;
    return line;
  } catch (const Malformed& malformed) {
    throw std::runtime_error(path_.string() + ":" + std::to_string(number_) + ": " + malformed.what());
  }
}

}  // namespace mrroc::cli::trace
