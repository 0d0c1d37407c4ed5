#include "links/exchange/sensor_responder.hpp"

#include <limits>

#include "links/transport/topic_name.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {

SensorResponder::SensorResponder(Domain& domain, clock::Clock& clock, const std::string& prefix,
                                 const std::vector<std::string>& clients, bool published) {
  std::vector<WriterBase*> also;
  if (published) {
    published_ = std::make_unique<Writer<SensorReading>>(domain, clock, topic_name(prefix, "published"));
    also.push_back(published_.get());
  }
  constexpr double kAnyAge = std::numeric_limits<double>::infinity();  // a late request for a reading is harmless
  for (const std::string& client : clients) {
    clients_.push_back(std::make_unique<Responder<SensorRequest, SensorReading>>(
        domain, clock, topic_name(prefix, client + "/request"), topic_name(prefix, client + "/reading"), kAnyAge,
        also));
  }
}

bool SensorResponder::take(SensorRequest& request, Caller& caller) {
  for (std::size_t i = 0; i < clients_.size(); ++i) {
    if (clients_[i]->take(request, caller.sequence)) {
      caller.client = i;
      return true;
    }
  }
  return false;
}

bool SensorResponder::reply(const SensorReading& reading, const Caller& caller) {
  return clients_.at(caller.client)->reply(reading, caller.sequence);
}

void SensorResponder::publish(const SensorReading& reading) {
  if (!published_) throw SystemError(ErrorCode::configuration, "a sensor without published readings publishes one");
  published_->write(reading, ++publications_);
}

}  // namespace mrroc::links
