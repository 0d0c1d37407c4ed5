#include "links/trajectory/trajectory_receiver.hpp"

#include "links/exchange/connect.hpp"
#include "links/transport/topic_name.hpp"
#include "mrroc/joint_trajectory.hpp"

namespace mrroc::links {

namespace {

/// A task that does not look for a while finds all parts of the longest trajectory.
std::size_t most_parts() noexcept { return JointTrajectory::most_numbers(kMaxJoints) / TrajectoryPart::kNumbers + 2; }

}  // namespace

TrajectoryReceiver::TrajectoryReceiver(Domain& domain, clock::Clock& clock, const std::string& prefix)
    : writer_(domain, clock, topic_name(prefix, "trajectory_report")),
      reader_(domain, clock, topic_name(prefix, "trajectory"), {.depth = most_parts()}) {}

void TrajectoryReceiver::connect(double timeout) { links::connect(writer_, {&reader_}, timeout, "the operator"); }

bool TrajectoryReceiver::take(TrajectoryPart& part) {
  Header header;
  return reader_.take(part, header);
}

}  // namespace mrroc::links
