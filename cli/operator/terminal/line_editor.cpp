#include "cli/operator/terminal/line_editor.hpp"

#include "cli/operator/operator_verbs.hpp"

namespace mrroc::cli {

namespace {

constexpr char kBackspace = '\x08', kDelete = '\x7f', kEscape = '\x1b', kEraseLine = '\x15', kEraseWord = '\x17';

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

}  // namespace

std::string LineEditor::feed(std::string_view bytes) {
  std::string lines;
  for (const char byte : bytes) take(byte, lines);
  return lines;
}

void LineEditor::take(char byte, std::string& lines) {
  if (escape_ == Escape::begun) {
    escape_ = byte == '[' || byte == 'O' ? Escape::sequence : Escape::none;
    return;
  }
  if (escape_ == Escape::sequence) {
    if (byte >= '0' && byte <= '?') return;  // parameters
    escape_ = Escape::none;
    if (byte == 'A') text_ = last_;
    return;
  }
  switch (byte) {
    case kEscape:
      escape_ = Escape::begun;
      return;
    case '\r':
    case '\n':
      if (!text_.empty()) last_ = text_;
      lines += text_ + "\n";
      text_.clear();
      return;
    case kBackspace:
    case kDelete:
      return erase_character();
    case kEraseLine:
      return text_.clear();
    case kEraseWord:
      return erase_word();
    case '\t':
      return complete();
    default:
      break;
  }
  if (byte == ' ' && text_.empty()) {
    lines += " \n";
  } else if ((static_cast<unsigned char>(byte) >= 0x20) && text_.size() < kMaxLine) {
    text_ += byte;
  }
}

void LineEditor::erase_character() {
  while (!text_.empty() && continues_character(text_.back())) text_.pop_back();
  if (!text_.empty()) text_.pop_back();
}

void LineEditor::erase_word() {
  while (!text_.empty() && text_.back() == ' ') text_.pop_back();
  while (!text_.empty() && text_.back() != ' ') text_.pop_back();
}

void LineEditor::complete() {
  const OperatorVerb* found = nullptr;
  for (const OperatorVerb& verb : operator_verbs()) {
    if (!verb.name.starts_with(text_)) continue;
    if (found != nullptr) return;  // not one verb alone
    found = &verb;
  }
  if (found != nullptr) text_ = std::string{found->name} + (found->arguments.empty() ? "" : " ");
}

}  // namespace mrroc::cli
