#include "cli/can/can_summary.hpp"

#include <spdlog/fmt/fmt.h>

namespace mrroc::cli {

void CanSummary::add(const can::Frame& frame) {
  if (frame.error) {
    ++errors_;
    return;
  }
  Count& count = counts_[frame.id];
  ++count.frames;
  if (frame.fd)
    ++fd_;
  else
    count.bits += bits_on_the_wire(frame.remote ? 0 : frame.size);
}

std::string CanSummary::text(const CanFrameFormatter& words, double seconds, double bit_rate) const {
  const auto per_second = [seconds](std::uint64_t number) {
    return seconds > 0 ? static_cast<double>(number) / seconds : 0.0;
  };
  std::string text = fmt::format("{:<4}  {:<28}  {:>9}  {:>9}  {:>7}\n", "id", "what", "frames", "per s", "load %");
  Count all;
  for (const auto& [id, count] : counts_) {
    const std::string kind = words.kind(id);
    text += fmt::format("{:03X}h  {:<28}  {:>9}  {:>9.1f}  {:>7.2f}\n", id, kind.empty() ? "-" : kind, count.frames,
                        per_second(count.frames), 100 * per_second(count.bits) / bit_rate);
    all.frames += count.frames;
    all.bits += count.bits;
  }
  text += fmt::format("{:<4}  {:<28}  {:>9}  {:>9.1f}  {:>7.2f}\n", "all", fmt::format("in {:.3f} s", seconds),
                      all.frames, per_second(all.frames), 100 * per_second(all.bits) / bit_rate);
  if (fd_ > 0) text += fmt::format("{} frames of CAN FD are counted without their load\n", fd_);
  if (errors_ > 0) text += fmt::format("{} errors that the controller has reported\n", errors_);
  return text;
}

}  // namespace mrroc::cli
