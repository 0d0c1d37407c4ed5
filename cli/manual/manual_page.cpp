#include "cli/manual/manual_page.hpp"

#include <sstream>

#include "cli/manual/verbs.hpp"

namespace mrroc::cli {

namespace {

/// Text that troff prints as it is: no line of it is a request.
std::string troff(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if ((letter == '.' || letter == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (letter == '\\') {
      out += "\\e";
    } else if (letter == '-') {
      out += "\\-";
    } else {
      out += letter;
    }
  }
  return out;
}

/// "--clock {real,paced,lockstep}", "-h,--help"
std::string heading(const CLI::Option& option) {
  std::string names = option.get_name(false, true);
  if (option.get_items_expected_max() == 0) return "\\fB" + troff(names) + "\\fR";
  std::string value;
  for (const std::string& choice : choices_of(option)) value += (value.empty() ? "" : "|") + choice;
  return "\\fB" + troff(names) + "\\fR \\fI" + troff(value.empty() ? option.get_type_name() : value) + "\\fR";
}

void write_arguments(std::ostream& out, const CLI::App& app) {
  for (const CLI::Option* argument : positional_arguments(app))
    out << ".TP\n\\fI" << troff(argument->get_name(true)) << "\\fR\n" << troff(argument->get_description()) << "\n";
  for (const CLI::Option* option : dashed_options(app))
    out << ".TP\n" << heading(*option) << "\n" << troff(option->get_description()) << "\n";
}

std::string synopsis(const std::string& command, const Verb& verb) {
  std::string line =
      "\\fB" + troff(command + (verb.words.empty() ? "" : " " + verb.words)) + "\\fR [\\fIOPTION\\fR...]";
  for (const CLI::Option* argument : positional_arguments(*verb.app)) {
    const std::string name = "\\fI" + troff(argument->get_name(true)) + "\\fR";
    line += argument->get_required() ? " " + name : " [" + name + "]";
  }
  return line;
}

}  // namespace

std::string manual_page(const CLI::App& app, const std::string& version) {
  const std::string& command = app.get_name();
  const std::vector<Verb> verbs = verbs_of(app);
  std::ostringstream out;
  out << ".TH MRROC 1 \"\" \"MRROC++ " << troff(version) << "\" \"User Commands\"\n";
  out << ".SH NAME\n"
      << troff(command) << " \\- program several robots and their sensors as one system\n.SH SYNOPSIS\n";
  for (const Verb& verb : verbs)
    if (verbs_below(*verb.app).empty()) out << synopsis(command, verb) << "\n.br\n";
  out << ".SH DESCRIPTION\n" << troff(app.get_description()) << "\n";
  for (const Verb& verb : verbs) {
    if (verb.words.empty()) {
      out << ".SH OPTIONS\n";
    } else {
      out << ".SH " << troff(command + " " + verb.words) << "\n" << troff(verb.app->get_description()) << "\n";
    }
    write_arguments(out, *verb.app);
  }
  out << ".SH EXIT STATUS\n0 when the command succeeded. 2 when arguments or files are wrong: nothing was moved. 1, 3 "
         "and 4: how a "
         "task ended, by the class of its error.\n";
  out << ".SH FILES\n.TP\n.I /usr/share/mrroc/\nRobots, sensors, and tasks with their scenes.\n";
  out << ".TP\n.I /usr/libexec/mrroc/\nThe programs that \\fBmrroc run\\fR starts.\n";
  return out.str();
}

}  // namespace mrroc::cli
