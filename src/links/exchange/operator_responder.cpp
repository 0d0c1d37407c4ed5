#include "links/exchange/operator_responder.hpp"

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

OperatorResponder::OperatorResponder(Domain& domain, clock::Clock& clock, const std::string& prefix)
    : writer_(domain, clock, topic_name(prefix, "answer")),
      reader_(domain, clock, topic_name(prefix, "question"), {.answer_through = {&writer_}}) {}

bool OperatorResponder::take(OperatorQuestion& question, std::uint64_t& number) {
  Header header;
  if (!reader_.take(question, header)) return false;
  number = header.sequence;
  return true;
}

void OperatorResponder::answer(const OperatorAnswer& answer) { writer_.write(answer, ++answered_); }

}  // namespace mrroc::links
