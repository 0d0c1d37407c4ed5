// Packets of any content in any order at both ends of RDT: requests at a sensor, records at its client.
#include "drivers/netft/rdt.hpp"

#include <algorithm>
#include <array>

#include "drivers/netft/record_sequence.hpp"
#include "fuzz/fuzz.hpp"

namespace {

using namespace mrroc::netft;

void check_request(std::span<const std::uint8_t> packet) {
  const auto request = decode_request(packet);
  if (!request) return;
  const auto again = encode(*request);
  fuzz::require(std::equal(again.begin(), again.end(), packet.begin(), packet.end()), "a request round-trips");
}

void check_status(std::uint32_t status) {
  const StatusText text = status_text(status);
  const std::string_view line = text.view();
  fuzz::require(line.size() > 12 && line.substr(0, 2) == "0x", "a status has a text");
  fuzz::require(std::all_of(line.begin(), line.end(), [](char letter) { return letter >= 0x20 && letter < 0x7f; }),
                "a status is one printable line");
  fuzz::require(status == 0 || line.find("healthy") == std::string_view::npos, "only 0 is healthy");
}

void check_records(std::span<const std::uint8_t> packet, RecordSequence& sequence) {
  for (std::size_t i = 0; i < records_in(packet.size()); ++i) {
    const Record record = decode_record(packet, i);
    const auto again = encode(record);
    fuzz::require(std::equal(again.begin(), again.end(), packet.begin() + static_cast<std::ptrdiff_t>(i * kRecordSize)),
                  "a record round-trips");
    check_status(record.status);
    const std::uint64_t doubled = sequence.doubled();
    sequence.add(record.rdt_sequence);
    fuzz::require(sequence.add(record.rdt_sequence) == Place::doubled && sequence.doubled() > doubled,
                  "a record that comes again is doubled");
    const bool each_once = sequence.lost() <= sequence.received() * RecordSequence::kMaxGap;
    fuzz::require(each_once && sequence.late() + sequence.doubled() + sequence.restarts() <= sequence.received(),
                  "every record is counted once");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes input(data, size);
  RecordSequence sequence;
  while (!input.empty()) {
    std::array<std::uint8_t, kMaxPacketSize + 1> packet{};
    const std::size_t length =
        std::min<std::size_t>(input.take<std::uint16_t>() % (packet.size() + 1), input.rest().size());
    input.take(packet.data(), length);
    check_request(std::span(packet).first(length));
    check_records(std::span(packet).first(length), sequence);
  }
  return 0;
}
