#include "links/trajectory/trajectory_sender.hpp"

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

namespace {

constexpr std::size_t kReports = 64;  // between two turns of the operator's end

}  // namespace

TrajectorySender::TrajectorySender(Domain& domain, clock::Clock& clock, const std::string& prefix)
    : writer_(domain, clock, topic_name(prefix, "trajectory")),
      reader_(domain, clock, topic_name(prefix, "trajectory_report"),
              {.depth = kReports, .answer_through = {&writer_}}) {}

bool TrajectorySender::take(TrajectoryReport& report) {
  Header header;
  return reader_.take(report, header);
}

}  // namespace mrroc::links
