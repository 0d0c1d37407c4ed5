// The main program of a group of tests that are compiled together: with `--of=FILE`, any number of them, it runs the
// test cases of these sources only. The other options are GoogleTest's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// The test cases of a group, by whether they are written in the files that were named.
struct Cases {
  std::set<std::string> chosen, others;  ///< Suite.Case; of a whole suite Suite.*
  std::set<std::string> files;           ///< with a test case
};

bool is_of(std::string_view path, const std::string& file) {
  const std::string end = "/" + file;
  return path.size() >= end.size() && path.substr(path.size() - end.size()) == end;
}

Cases choose(const std::vector<std::string>& files) {
  Cases cases;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    std::set<std::string> chosen, others;
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      const auto file =
          std::find_if(files.begin(), files.end(), [&](const std::string& name) { return is_of(test.file(), name); });
      if (file != files.end()) cases.files.insert(*file);
      (file != files.end() ? chosen : others).insert(std::string(suite.name()) + "." + test.name());
    }
    if (others.empty()) chosen = {std::string(suite.name()) + ".*"};
    if (chosen.empty()) others = {std::string(suite.name()) + ".*"};
    cases.chosen.merge(chosen);
    cases.others.merge(others);
  }
  return cases;
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ":").append(name);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind("--of=", 0) != 0) {
      std::fprintf(stderr, "unknown argument '%s', expected --of=FILE or an option of GoogleTest\n", argv[i]);
      return 2;
    }
    files.push_back(argument.substr(5));
  }
  if (files.empty()) return RUN_ALL_TESTS();

  const Cases cases = choose(files);
  for (const std::string& file : files)
    if (cases.files.count(file) == 0) {
      std::fprintf(stderr, "%s has no test case\n", file.c_str());
      return 2;
    }
  for (const std::string& name : cases.others)
    if (cases.chosen.count(name) > 0) {
      std::fprintf(stderr, "%s is in two files of this group\n", name.c_str());
      return 2;
    }
  std::string& filter = testing::GTEST_FLAG(filter);
  if (filter == "*")
    filter = joined(cases.chosen);
  else  // the caller's still holds
    filter.append(filter.find('-') == std::string::npos ? "-" : ":").append(joined(cases.others));
  return RUN_ALL_TESTS();
}
