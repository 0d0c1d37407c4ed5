#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/irb6/family/changed_file.hpp"
#include "robots/irb6_track/irb6_track_model.hpp"

namespace mrroc {
namespace {

using testing::HasSubstr;

std::string mistake(const std::string& from, const std::string& to) {
  return error_with([](const std::filesystem::path& file) { return load_irb6_track(file); }, from, to);
}

TEST(Irb6TrackFile, ErrorsNameTheirKey) {
  EXPECT_EQ(mistake("gear = 1570.7963267948967", "gear = 1570.8"), "");
  EXPECT_THAT(mistake("gear = 1570.7963267948967", "gear = 0.0"), HasSubstr("track.gear"));
  EXPECT_THAT(mistake("[track]", "[truck]"), HasSubstr("track"));
  EXPECT_THAT(mistake("wrist = 0.1967", "wrist = 0"), HasSubstr("models.calibrated.wrist"));
  EXPECT_THAT(mistake("name = \"track\"", "name = \"column\""), HasSubstr("axes"));
}

TEST(Irb6TrackFile, InstalledFileHasTheModelsByName) {
  std::vector<std::string> names;
  for (const auto& model : load_irb6_track()) names.emplace_back(model->name());
  EXPECT_THAT(names, testing::ElementsAre("track_still", "track_used", "calibrated"));
}

}  // namespace
}  // namespace mrroc
