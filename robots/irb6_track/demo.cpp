#include <mrroc/ecp.hpp>
#include <mrroc/robots/irb6_track.hpp>

using namespace mrroc;

/// A tour of the workspace: to both ends of the track, at each the tool to both sides; then along the track
/// with the track alone, and home.
class Tour : public ecp::Task {
  Irb6Track arm{*this};

  void run() override {
    for (const double track : {0.05, 1.05}) {
      JointVector joints = arm.parameters().home;
      joints[0] = track;
      Move({arm}, {}, JointLine{arm, joints, 0.9});
      for (const double y : {track - 0.3, track + 0.3}) {
        Move({arm}, {}, JointLine{arm, Irb6Track::tool_down(0.7, y, 0.0), 0.9});
      }
    }
    arm.use_model("track_used");  // from now on the track moves instead of the column
    Move({arm}, {}, JointLine{arm, Irb6Track::tool_down(0.7, 0.6, 0.0), 0.9});
    arm.use_model("track_still");
    Move({arm}, {}, JointLine{arm, arm.parameters().home, 0.9});
  }
};

MRROC_ECP(Tour)
