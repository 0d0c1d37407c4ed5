#include "links/exchange/sensor_requester.hpp"

#include <algorithm>

#include "links/transport/topic_name.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::links {

SensorRequester::SensorRequester(Domain& domain, clock::Clock& clock, const std::string& prefix,
                                 const std::string& client, std::string peer, SensorRequesterOptions options)
    : clock_(clock),
      timeout_(options.timeout),
      polled_(options.polled),
      exchange_(domain, clock, topic_name(prefix, client + "/request"), topic_name(prefix, client + "/reading"),
                std::move(peer)) {
  if (options.published) published_.emplace(domain, clock, topic_name(prefix, "published"));
}

void SensorRequester::connect(double timeout) {
  std::vector<ReaderBase*> also;
  if (published_) also.push_back(&*published_);
  exchange_.connect(timeout, std::move(also));
}

bool SensorRequester::await_published(Tick until) {
  SensorReading reading;
  while (!latest(reading)) {
    if (!published_ || clock_.tick() >= until) return false;
    if (clock_.wait(until) == clock::Wake::interrupted) throw Stopped{};
  }
  return true;
}

void SensorRequester::request(const SensorRequest& request) {
  exchange_.send(request, std::max(clock_.tick(), request.measure_at) + timeout_);
}

}  // namespace mrroc::links
