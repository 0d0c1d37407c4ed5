#include "links/exchange/connect.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

void check(const std::string& problem) {
  if (!problem.empty()) throw SystemError(ErrorCode::configuration, problem);
}

}  // namespace

void connect(WriterBase& to, const std::vector<ReaderBase*>& from, double timeout, const std::string& peer) {
  constexpr int kPingEvery = 20;  // checks, one per millisecond: no clock is read
  const auto silent = [](const ReaderBase* reader) { return reader->ponged() == 0; };
  for (ReaderBase* reader : from) reader->expect_pong();
  const auto looks = static_cast<long>(std::ceil(timeout * 1e3));
  for (long look = 0; look <= looks; ++look) {
    if (look % kPingEvery == 0) to.ping();
    if (std::none_of(from.begin(), from.end(), silent)) return;
    check(to.problem());
    for (const ReaderBase* reader : from) check(reader->problem());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const auto missing = std::find_if(from.begin(), from.end(), silent);
  if (missing == from.end()) return;
  throw SystemError(ErrorCode::link_lost, peer + " does not answer: nothing on topic " + (*missing)->topic() +
                                              " after pings on " + to.topic() + " for " + std::to_string(timeout) +
                                              " s");
}

}  // namespace mrroc::links
