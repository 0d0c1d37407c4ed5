#include "command/parse_command.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "command/version.hpp"

namespace mrroc::command {
namespace {

/// A command with a verb `run`, whose options have values, and a flag.
struct Command {
  Command() {
    app.name("tool");
    CLI::App* run = app.add_subcommand("run");
    run->add_option("FILE", file);
    run->add_option("--black-box", black_box);
    run->add_option("--trace", trace);
    run->add_flag("--quiet", quiet);
  }
  void parse(const std::vector<std::string>& words) {
    std::vector<std::string> reversed = words_of(app, words);
    std::reverse(reversed.begin(), reversed.end());
    app.parse(std::move(reversed));
  }
  std::optional<int> exit_code(std::vector<std::string> words) {
    words.insert(words.begin(), "tool");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    return parse_command(app, static_cast<int>(argv.size()), argv.data());
  }

  CLI::App app;
  std::string file = "none", black_box = "default", trace = "none";
  bool quiet = false;
};

TEST(ParseCommand, EmptyValueTakesNoNextWord) {
  Command options;
  options.parse({"run", "--black-box=", "--trace", "t"});
  EXPECT_EQ(options.black_box, "");
  EXPECT_EQ(options.trace, "t");
  Command last;
  last.parse({"run", "x.toml", "--black-box="});
  EXPECT_EQ(last.file, "x.toml");
  EXPECT_EQ(last.black_box, "");
  Command positional;
  positional.parse({"run", "--trace=", "--black-box=", "x.toml"});
  EXPECT_EQ(positional.file, "x.toml");
  EXPECT_EQ(positional.trace, "");
  Command both;
  both.parse({"run", "--trace=", "--quiet", "--black-box=b"});
  EXPECT_EQ(both.trace, "");
  EXPECT_TRUE(both.quiet);
  EXPECT_EQ(both.black_box, "b");
}

TEST(ParseCommand, ValueMayContainEqualSignsAndMayBeTheNextWord) {
  Command options;
  options.parse({"run", "--trace=a=b=", "--black-box", ""});
  EXPECT_EQ(options.trace, "a=b=");
  EXPECT_EQ(options.black_box, "");
  Command after;
  after.parse({"run", "--", "--black-box="});
  EXPECT_EQ(after.file, "--black-box=");
}

TEST(ParseCommand, NumberWithoutALeadingDigitIsNoOption) {
  for (const auto& [word, number] :
       {std::pair{"-.5", -0.5}, {"-.25e1", -2.5}, {".5", 0.5}, {"-0.5", -0.5}, {"-1.", -1.0}}) {
    CLI::App app;
    double value = 0;
    app.add_option("VALUE", value);
    std::vector<std::string> words = words_of(app, {word});
    app.parse(std::move(words));
    EXPECT_EQ(value, number) << word;
  }
}

TEST(ParseCommand, FlagTakesNoValue) {
  for (const char* word : {"--quiet=", "--quiet=1", "--quiet=false", "--quiet=x"}) {
    Command options;
    EXPECT_THROW(options.parse({"run", word}), CLI::ParseError) << word;
  }
}

TEST(ParseCommand, RejectsUnknownWordsAsUsageErrors) {
  EXPECT_EQ(Command().exit_code({"run", "--unknown"}), 2);
  EXPECT_EQ(Command().exit_code({"run", "--unknown="}), 2);
  EXPECT_EQ(Command().exit_code({"walk"}), 2);
  EXPECT_EQ(Command().exit_code({"run", "--trace"}), 2) << "no value";
  EXPECT_EQ(Command().exit_code({"run", "--trace", "a", "--trace", "b"}), 2) << "twice";
  EXPECT_EQ(Command().exit_code({"run", "a", "b"}), 2);
}

TEST(ParseCommand, NamesTheUnknownOptionAndTheNearestOne) {
  const auto message = [](const std::vector<std::string>& words) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(Command().exit_code(words), 2);
    const std::string text = testing::internal::GetCapturedStderr();
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(message({"run", "file", "--quite", "--trace", "x"}),
            "unknown option '--quite' of run, did you mean '--quiet'?");
  EXPECT_EQ(message({"run", "--blackbox=x"}), "unknown option '--blackbox' of run, did you mean '--black-box'?");
  EXPECT_EQ(message({"--trace", "x", "run"}), "unknown option '--trace' of tool");
  EXPECT_EQ(message({"run", "--zzz"}), "unknown option '--zzz' of run");
  Command after;
  EXPECT_EQ(after.exit_code({"run", "--", "--quite"}), std::nullopt);
  EXPECT_EQ(after.file, "--quite");
  Command value;
  EXPECT_EQ(value.exit_code({"run", "--trace", "-5"}), std::nullopt);
}

TEST(ParseCommand, HelpAndVersionAreSuccesses) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(Command().exit_code({"--version"}), 0);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "tool (MRROC++) " + std::string{version()} + "\n");
  testing::internal::CaptureStdout();
  EXPECT_EQ(Command().exit_code({"run", "--help"}), 0);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("--black-box"), std::string::npos);
  EXPECT_EQ(Command().exit_code({"run"}), std::nullopt);
}

TEST(ParseCommand, ErrorContainsNoControlCharacters) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(Command().exit_code({"run", "a", "\x1b]0;title\x07"}), 2);
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(text.find('\x1b'), std::string::npos) << text;
  EXPECT_NE(text.find("\\x1b]0;title\\x07"), std::string::npos) << text;
}

}  // namespace
}  // namespace mrroc::command
