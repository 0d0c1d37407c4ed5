#include "links/exchange/responder.hpp"

#include "links/exchange/requester.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"

namespace mrroc::links {
namespace {

ReaderOptions answering(WriterBase& writer, std::vector<WriterBase*> also) {
  also.insert(also.begin(), &writer);
  return {.answer_through = std::move(also)};
}

}  // namespace

template <class Request, class Reply>
Responder<Request, Reply>::Responder(Domain& domain, clock::Clock& clock, const std::string& request_topic,
                                     const std::string& reply_topic, double max_age, std::vector<WriterBase*> also)
    : max_age_(max_age),
      writer_(domain, clock, reply_topic),
      reader_(domain, clock, request_topic, answering(writer_, std::move(also))) {}

template <class Request, class Reply>
bool Responder<Request, Reply>::take(Request& request, std::uint64_t& sequence) {
  if (!reader_.take_fresh(request, taken_, max_age_)) return false;
  sequence = taken_.sequence;
  return true;
}

template <class Request, class Reply>
bool Responder<Request, Reply>::reply(const Reply& reply, std::uint64_t sequence) {
  if (sequence != taken_.sequence) return false;
  writer_.write(reply, sequence, taken_.boot);
  return true;
}

template <class Request, class Reply>
bool Responder<Request, Reply>::forward(Requester<Request, Reply>& requester, std::uint64_t sequence) {
  if (sequence != taken_.sequence) return false;
  requester.reader_.forward(writer_, sequence, taken_.boot);
  return true;
}

template class Responder<RobotCommand, RobotState>;
template class Responder<SensorRequest, SensorReading>;

}  // namespace mrroc::links
