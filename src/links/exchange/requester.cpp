#include "links/exchange/requester.hpp"

#include "links/exchange/connect.hpp"
#include "links/exchange/responder.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/sensor_link.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::links {

template <class Request, class Reply>
Requester<Request, Reply>::Requester(Domain& domain, clock::Clock& clock, const std::string& request_topic,
                                     const std::string& reply_topic, std::string peer)
    : clock_(clock),
      peer_(std::move(peer)),
      boot_(domain.boot()),
      loopback_only_(domain.loopback_only()),
      writer_(domain, clock, request_topic),
      reader_(domain, clock, reply_topic) {}

template <class Request, class Reply>
void Requester<Request, Reply>::connect(double timeout, std::vector<ReaderBase*> also) {
  also.insert(also.begin(), &reader_);
  links::connect(writer_, also, timeout, peer_);
}

template <class Request, class Reply>
void Requester<Request, Reply>::send(const Request& request, Tick deadline) {
  deadline_ = deadline;
  writer_.write(request, ++sequence_);
}

template <class Request, class Reply>
void Requester<Request, Reply>::forward(Responder<Request, Reply>& responder, Tick deadline) {
  deadline_ = deadline;
  responder.reader_.forward(writer_, ++sequence_);
}

template <class Request, class Reply>
void Requester<Request, Reply>::receive(Reply& reply) {
  while (!poll(reply)) {
    if (clock_.wait(deadline_) == clock::Wake::interrupted) throw Stopped();
  }
}

template <class Request, class Reply>
bool Requester<Request, Reply>::poll(Reply& reply) {
  if (take_reply(reply)) return true;
  if (!clock_.simulated() && !reader_.peer_alive()) {
    if (take_reply(reply)) return true;  // its last message
    throw_lost();
  }
  if (clock_.tick() >= deadline_) {
    throw SystemError(ErrorCode::process_silent, peer_ + " has not answered on topic " + reader_.topic(),
                      {{}, {}, 0, clock_.tick()});
  }
  return false;
}

template <class Request, class Reply>
bool Requester<Request, Reply>::take_reply(Reply& reply) {
  return reader_.take_answer(reply, {.sequence = sequence_, .boot = reader_.ponged(), .answers = boot_});
}

template <class Request, class Reply>
void Requester<Request, Reply>::throw_lost() const {
  throw SystemError(loopback_only_ ? ErrorCode::process_died : ErrorCode::link_lost,
                    peer_ + " is gone from topic " + reader_.topic(), {{}, {}, 0, clock_.tick()});
}

template class Requester<RobotCommand, RobotState>;
template class Requester<SensorRequest, SensorReading>;

}  // namespace mrroc::links
