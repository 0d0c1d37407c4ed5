#include <algorithm>
#include <random>

#include "config/deployment_fixture.hpp"
#include "config/toml_places.hpp"
#include "text_of.hpp"

namespace mrroc::config::mutated_deployments_test {
namespace {

/// A valid file with one change is still valid, or is refused with the line and the key of the error.
class MutatedDeployment : public DeploymentFixture {
 protected:
  MutatedDeployment() : DeploymentFixture("valid") {
    text_ = test::text_of("full.toml");
    erase_line("host = ");  // nothing here shall ask the network
    erase_line("rate = ");  // together with `mode`: what depends on two keys has tests of its own
    erase_line("mode = \"non");
    for (const auto* file : {"scene.xml", "readings.txt"}) std::filesystem::copy_file(file, folder_.path() / file);
  }

  void erase_line(const std::string& begin) {
    const auto at = text_.find("\n" + begin) + 1;
    text_.erase(at, text_.find('\n', at) + 1 - at);
  }

  /// The file with line `number` replaced.
  std::string with_line(int number, const std::string& line) const {
    std::istringstream stream(text_);
    std::string result, content;
    for (int i = 1; std::getline(stream, content); ++i) result += (i == number ? line : content) + "\n";
    return result;
  }

  std::string refusal(const std::string& text) const {
    const auto file = folder_.write("mutated.toml", text);
    return message_of(folder_.path(), [&] { load_deployment(file); });
  }

  std::size_t random(std::size_t below) { return generator_() % below; }

  /// The word with one typing error: a letter dropped, doubled, replaced, or two swapped.
  std::string slip(std::string word) {
    const std::string before = word;
    while (word == before) {
      const std::size_t at = random(word.size());
      const char letter = static_cast<char>('a' + random(26));
      switch (random(4)) {
        case 0:
          word.erase(at, 1);
          break;
        case 1:
          word.insert(at, 1, word[at]);
          break;
        case 2:
          word[at] = letter;
          break;
        default:
          std::swap(word[at], word[(at + 1) % word.size()]);
      }
    }
    return word;
  }

  task_test::ScratchFolder folder_;
  std::string text_;
  std::mt19937_64 generator_{20240501};
};

TEST_F(MutatedDeployment, UnchangedFileIsValid) {
  EXPECT_EQ(refusal(text_), "");
  EXPECT_GE(TomlPlaces(text_).entries().size(), 30u);
}

TEST_F(MutatedDeployment, FileWithoutAKeyIsValidOrTheErrorNamesItsLine) {
  std::size_t refused = 0;
  for (const TomlPlaces places(text_); const auto& entry : places.entries()) {
    const std::string text = with_line(entry.line, "");
    const std::string message = refusal(text);
    if (message.empty()) continue;
    ++refused;
    const Complaint complaint(message);
    EXPECT_EQ(complaint.line, TomlPlaces(text).line(complaint.key)) << message;
    if (!complaint.problem.starts_with("missing")) continue;
    EXPECT_EQ(complaint.key, entry.section + "." + entry.key) << message;
    EXPECT_EQ(complaint.line, TomlPlaces(text).line(entry.section)) << message;
  }
  EXPECT_GE(refused, 10u);
}

TEST_F(MutatedDeployment, ValueOfAnotherTypeIsRefusedAtItsLine) {
  for (const TomlPlaces places(text_); const auto& entry : places.entries()) {
    for (const std::string value : {"\"?\"", "1", "0.5", "true", "[\"?\"]", "[]", "{ a = 1 }", "1979-05-27", "nan"}) {
      const std::string message = refusal(with_line(entry.line, entry.key + " = " + value));
      const auto kind = [](char c) { return c == '"' || c == '[' ? c : '0'; };
      const bool same_kind = kind(entry.value.front()) == kind(value.front()) && value.front() != '{' &&
                             value != "true" && value != "1979-05-27" && value != "nan";
      if (message.empty()) {
        EXPECT_TRUE(same_kind) << entry.section << "." << entry.key << " = " << value << " was accepted";
        continue;
      }
      const Complaint complaint(message);
      EXPECT_EQ(complaint.line, entry.line) << message;
      EXPECT_TRUE(complaint.key.starts_with(entry.section + "." + entry.key)) << message;
    }
  }
}

TEST_F(MutatedDeployment, MisspeltKeyIsNeverAccepted) {
  for (const TomlPlaces places(text_); const auto& entry : places.entries()) {
    for (int i = 0; i < 40; ++i) {
      const std::string key = slip(entry.key);
      const std::string full_key = entry.section + "." + key;
      if (places.has(full_key)) continue;
      const std::string text = with_line(entry.line, key + " = " + entry.value);
      const Complaint complaint(refusal(text));
      if (complaint.problem.starts_with("unknown key")) {
        EXPECT_EQ(complaint.key, full_key);
        EXPECT_EQ(complaint.line, entry.line);
      } else {  // the misspelt key is missing
        EXPECT_TRUE(complaint.problem.starts_with("missing")) << full_key << ": " << complaint.problem;
        EXPECT_EQ(complaint.key, entry.section + "." + entry.key);
        EXPECT_EQ(complaint.line, TomlPlaces(text).line(entry.section));
      }
    }
  }
}

TEST_F(MutatedDeployment, UnknownKeyInAnySectionIsRefused) {
  std::istringstream stream(text_);
  std::string content;
  std::size_t sections = 0;
  for (int line = 1; std::getline(stream, content); ++line) {
    if (!content.starts_with("[")) continue;
    ++sections;
    const Complaint complaint(refusal(with_line(line, content + "\nwhatever = 1")));
    EXPECT_EQ(complaint.line, line + 1) << content;
    EXPECT_TRUE(complaint.key.ends_with(".whatever")) << complaint.key;
    EXPECT_TRUE(complaint.problem.starts_with("unknown key")) << complaint.problem;
  }
  EXPECT_EQ(sections, 11u);
}

TEST_F(MutatedDeployment, RandomBytesGiveOnlyErrorsWithALine) {
  const std::string letters = "[]{}=\".,'#\\\n\r\t -+_0159eExnaif\x80\xFF";
  std::size_t refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = text_;
    for (std::size_t edits = 1 + random(3); edits > 0; --edits) {
      const std::size_t at = random(text.size());
      switch (random(4)) {
        case 0:
          text.erase(at, 1 + random(8));
          break;
        case 1:
          text.insert(at, 1, letters[random(letters.size())]);
          break;
        case 2:
          text[at] = letters[random(letters.size())];
          break;
        default:
          text.insert(at, text.substr(random(text.size()), random(60)));
      }
    }
    const std::string message = refusal(text);
    if (message.empty()) continue;
    ++refused;
    const int line = Complaint(message).line;
    EXPECT_GE(line, 1) << message << "\n" << text;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LE(line, std::count(text.begin(), text.end(), '\n') + 1) << message;
  }
  EXPECT_GE(refused, 1000u);
}

}  // namespace
}  // namespace mrroc::config::mutated_deployments_test
