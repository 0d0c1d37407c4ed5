#include "links/exchange/operator_requester.hpp"

#include "links/exchange/connect.hpp"
#include "links/transport/topic_name.hpp"

namespace mrroc::links {

OperatorRequester::OperatorRequester(Domain& domain, clock::Clock& clock, const std::string& prefix)
    : writer_(domain, clock, topic_name(prefix, "question")), reader_(domain, clock, topic_name(prefix, "answer")) {}

void OperatorRequester::connect(double timeout) { links::connect(writer_, {&reader_}, timeout, "the operator"); }

std::uint64_t OperatorRequester::ask(const OperatorQuestion& question) {
  writer_.write(question, ++asked_);
  return asked_;
}

bool OperatorRequester::take(OperatorAnswer& answer) {
  Header header;
  return reader_.take(answer, header);
}

}  // namespace mrroc::links
