#include "mrroc/taught_path.hpp"

#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>

#include "language/free_flyer.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "text_of.hpp"

namespace mrroc::taught_path_test {
namespace {

using fakes::check_property;
using fakes::FakeTask;
using fakes::FreeFlyer;
using fakes::pick;
using Space = TaughtPath::Space;

/// A number with all its digits.
double digits(double size) { return size * pick(-1000000, 1000000) / 999983.0; }

/// A file of this test, removed with the object.
struct File {
  void write(const std::string& text) const { std::ofstream(name, std::ios::binary) << text; }
  std::string read() const { return test::text_of(name); }
  task_test::ScratchFolder folder;
  std::string name = folder / "path.csv";
};

TaughtPath random_path() {
  TaughtPath path;
  path.space = pick(0, 1) == 0 ? Space::joints : Space::poses;
  path.timed = pick(0, 1) == 1;
  double time = 0;
  for (int count = pick(1, 30); count > 0; --count) {
    TaughtPoint point;
    if (path.timed) point.time = time;
    time += 1e-3 + std::abs(digits(1));
    point.joints.resize(6);
    for (double& joint : point.joints) joint = digits(1.9);
    point.pose.translation() << digits(1), digits(1), digits(1);
    point.pose.linear() = exp_rotation({digits(2), digits(2), digits(2)});
    path.points.push_back(point);
  }
  return path;
}

TEST(TaughtPath, SavedPathReadsBack) {
  check_property(200, [] {
    FreeFlyer task(Pose::Identity());
    const File file;
    const TaughtPath path = random_path();
    save(path, *task.arm, file.name);
    const TaughtPath back = load_taught_path(file.name, *task.arm);
    RC_ASSERT(back.space == path.space);
    RC_ASSERT(back.timed == path.timed);
    RC_ASSERT(back.points.size() == path.points.size());
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const TaughtPoint &a = path.points[i], &b = back.points[i];
      if (path.timed) RC_ASSERT(a.time == b.time);
      if (path.space == Space::joints) {
        RC_ASSERT(a.joints == b.joints);  // to the bit
      } else {
        RC_ASSERT(Eigen::Vector3d{a.pose.translation()} == Eigen::Vector3d{b.pose.translation()});
        RC_ASSERT((a.pose.linear() - b.pose.linear()).norm() < 1e-14);
      }
    }
    RC_ASSERT(!std::filesystem::exists(file.name + ".new"));
  });
}

TEST(TaughtPath, HandwrittenFileMayHaveCommentsBlanksAndEmptyLines) {
  FreeFlyer task(Pose::Identity());
  const File file;
  file.write(
      "# by hand\n\n time , axis0, axis1,axis2,axis3,axis4,axis5\r\n0, 1,0,0,0,0,-1.5e-1\n# more\n  2.5,0,0,0,0,0,0  ");
  const TaughtPath path = load_taught_path(file.name, *task.arm);
  ASSERT_EQ(path.points.size(), 2u);
  EXPECT_TRUE(path.timed);
  EXPECT_EQ(path.points[0].joints[5], -0.15);
  EXPECT_EQ(path.points[1].time, 2.5);
}

TEST(TaughtPath, AcceptsAdditionsOfEditorsAndSpreadsheets) {
  FreeFlyer task(Pose::Identity());
  const File file;
  const std::string columns = "time,axis0,axis1,axis2,axis3,axis4,axis5";
  for (const std::string& text : std::vector<std::string>{
           "\xEF\xBB\xBF" + columns + "\n0,0.5,0,0,0,0,0\n1,0,0,0,0,0,0\n",
           "\xEF\xBB\xBF# a comment\r\n" + columns + "\r\n0,+0.5,0,0,0,0,0\r\n1,0,0,0,0,0,0",
           columns + ",,\n0,.5,0,0,0,0,0,,\n,,,,,,,,\n1,0,0,0,0,0,0,,\n",
           "\"# a comment\",,,\n\"time\",\"axis0\",\"axis1\",\"axis2\",\"axis3\",\"axis4\",\"axis5\"\n"
           "0,\"5e-1\",0,0,0,0,0\n1,0,0,0,0,0,0\n;;;;;;\n",
           columns + " # in rad\n\n0,0.5,0,0,0,0,0 \t# here\n \t\n1.,0,0,0,0,0,0\n\x1A"}) {
    file.write(text);
    const TaughtPath path = load_taught_path(file.name, *task.arm);
    ASSERT_EQ(path.points.size(), 2u) << text;
    EXPECT_EQ(path.points[0].joints[0], 0.5) << text;
    EXPECT_EQ(path.points[1].time, 1) << text;
  }
}

TEST(TaughtPath, RefusesTimesInMilliseconds) {
  FreeFlyer task(Pose::Identity());
  const File file;
  const auto reported = [&](double scale, double way, double duration) -> std::string {
    std::string text = "time,axis0,axis1,axis2,axis3,axis4,axis5\n";
    for (int i = 0; i <= 10; ++i)
      text += std::to_string(scale * duration * i / 10) + ",0," + std::to_string(way * i / 10) + ",0,0,0,0\n";
    file.write(text);
    try {
      load_taught_path(file.name, *task.arm);
      return "";
    } catch (const NonFatalError& error) {
      return error.detail();
    }
  };
  for (const double way : {0.01, 0.1, -1.0, 1.5, 2.0}) {
    EXPECT_EQ(reported(1, way, 50), "") << way;
    EXPECT_NE(reported(1000, way, 50).find("expected seconds, not milliseconds"), std::string::npos) << way;
  }
  EXPECT_NE(reported(1000, 1, 50.4).find(":12: time: '50400': makes a path of 14 h"), std::string::npos);
  EXPECT_EQ(reported(1000, 0, 50), "") << "a robot at rest";
  EXPECT_EQ(reported(1000, 0.0001, 0.5), "") << "less than ten minutes";
}

TEST(TaughtPath, ErrorNamesFileLineColumnValueAndExpectation) {
  FreeFlyer task(Pose::Identity());
  const File file;
  const auto reported = [&](const std::string& text) -> std::string {
    file.write(text);
    try {
      load_taught_path(file.name, *task.arm);
    } catch (const NonFatalError& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
      const std::string detail = error.detail();
      EXPECT_EQ(detail.find(file.name), 0u) << detail;
      return detail.substr(std::min(detail.size(), file.name.size()));
    }
    return "nothing wrong";
  };
  const std::string head = "# a comment\ntime,axis0,axis1,axis2,axis3,axis4,axis5\n";
  EXPECT_EQ(reported(head + "0,0,0,0,0,0,0\n"), "nothing wrong");
  EXPECT_EQ(reported(head + "0,0,0,fast,0,0,0\n"),
            ":3: axis2: 'fast': is not a number, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,0,0,,0,0,0\n"), ":3: axis2: '': is empty, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,0,0,nan,0,0,0\n"),
            ":3: axis2: 'nan': is not a number, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,0,0,1e999,0,0,0\n"),
            ":3: axis2: '1e999': is not a number, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,0,0,1 2,0,0,0\n"),
            ":3: axis2: '1 2': is not a number, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,0,0,1\xC2\xA0,0,0,0\n"),
            ":3: axis2: '1U+00A0': has U+00A0 at character 2, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,0,0,0,0,0,\n"), ":3: axis5: '': is empty, expected a finite number such as -0.25");
  EXPECT_EQ(reported(head + "0,1,0,1,0,1,0,1\n"),
            ":3: 8 values, expected 7, one for each of 'time,axis0,axis1,axis2,axis3,axis4,axis5'; numbers have a "
            "point, not a comma");
  EXPECT_EQ(reported("time;axis0;axis1;axis2;axis3;axis4;axis5\n"),
            ":1: columns with semicolons between, expected commas between the columns, and points in numbers");
  EXPECT_EQ(reported("time\taxis0\taxis1\n"),
            ":1: columns with tabs between, expected commas between the columns, and points in numbers");
  EXPECT_EQ(reported("\xFE\xFF"), ":1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(reported("# a\rtime\r"),
            ":1: a carriage return (\\x0D) at column 4, expected lines that end with LF or CRLF");
  EXPECT_EQ(reported(head + "0,0,0,0,0,0,2.5\n"), ":3: axis5: '2.5': is beyond the robot's limits, expected -2 to 2");
  EXPECT_EQ(reported(head + "0,0,0,0,0,0,0\n0,0,0,0,0,0,0\n"),
            ":4: time: '0': does not come after the point before, expected more than 0");
  EXPECT_EQ(reported(head + "-1,0,0,0,0,0,0\n"),
            ":3: time: '-1': does not come after the point before, expected at least 0");
  EXPECT_EQ(reported(head + "0,0,0,0,0,0\n"),
            ":3: 6 values, expected 7, one for each of 'time,axis0,axis1,axis2,axis3,axis4,axis5'");
  EXPECT_EQ(reported(head), ":2: no point, expected at least one line of values");
  EXPECT_EQ(reported(""), ": no line of column names, expected 'time,axis0,axis1,axis2,axis3,axis4,axis5'");
  EXPECT_EQ(reported("time,axis0,axis1\n"),
            ":1: columns 'time,axis0,axis1' are not those of a path of robot fake, expected "
            "'time,axis0,axis1,axis2,axis3,axis4,axis5' or "
            "'time,x,y,z,qw,qx,qy,qz', each also without time");
  EXPECT_EQ(reported("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0.2\n").find(":2: qw,qx,qy,qz: a quaternion of length 1.0198"),
            0u);
  EXPECT_EQ(reported("x,y,z,qw,qx,qy,qz\n0,0,inf,1,0,0,0\n"),
            ":2: z: 'inf': is not a number, expected a finite number such as -0.25");
  std::filesystem::remove(file.name);
  try {
    load_taught_path(file.name, *task.arm);
    FAIL() << "no error";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.detail(), file.name + ": cannot be read, expected a file with a taught path");
  }
}

// every character of a good file changed: the file is refused in one line, or is still a path within the limits
TEST(TaughtPath, BrokenFileIsRefusedOrAValidPath) {
  FreeFlyer task(Pose::Identity());
  const File file;
  TaughtPath path;
  path.timed = true;
  for (int i = 0; i < 3; ++i) path.points.push_back({0.5 * i, JointVector::Constant(6, 0.125 * i), Pose::Identity()});
  save(path, *task.arm, file.name);
  const std::string good = file.read();
  int refused = 0, taken = 0;
  for (std::size_t place = 0; place < good.size(); ++place) {
    for (const char wrong : {'x', ',', '\n', '9', '-', '\0', '\xff'}) {
      std::string broken = good;
      broken[place] = wrong;
      file.write(broken);
      try {
        const TaughtPath read = load_taught_path(file.name, *task.arm);
        ++taken;
        for (const TaughtPoint& point : read.points) ASSERT_LE(point.joints.cwiseAbs().maxCoeff(), 2) << broken;
      } catch (const NonFatalError& error) {
        ++refused;
        EXPECT_EQ(error.detail().find(file.name), 0u);
      }
    }
  }
  std::printf("%d refused, %d still a path\n", refused, taken);
  EXPECT_GT(refused, 300);
}

TEST(TaughtPath, ReportsAWriteErrorAndKeepsTheOldFile) {
  FreeFlyer task(Pose::Identity());
  const File file;
  EXPECT_THROW(save({}, *task.arm, file.name), NonFatalError) << "no point";
  EXPECT_FALSE(std::filesystem::exists(file.name));
  TaughtPath path;
  path.points.push_back({0, JointVector::Zero(6), Pose::Identity()});
  try {
    save(path, *task.arm, "/no/such/folder/path.csv");
    FAIL() << "no error";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.detail().find("/no/such/folder/path.csv: cannot be written"), 0u) << error.detail();
  }
}

TEST(TaughtPath, AddsTheDesiredPositionOfTheRobot) {
  FakeTask task;
  const auto arm = task.robot("arm");
  TaughtPath path;
  EXPECT_THROW(path.add(*arm), NonFatalError) << "the state is unknown";
  task.robot_fake("arm").state.desired_joints << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  Wait({*arm}, {}, ElapsedSteps{0});
  path.add(*arm, 1.5);
  ASSERT_EQ(path.points.size(), 1u);
  EXPECT_EQ(path.points[0].joints, task.robot_fake("arm").state.desired_joints);
  EXPECT_EQ(path.points[0].time, 1.5);
}

}  // namespace
}  // namespace mrroc::taught_path_test
