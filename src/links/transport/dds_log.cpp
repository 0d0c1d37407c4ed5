#include "links/transport/dds_log.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

#include "mrroc/fixed_text.hpp"

namespace mrroc::links {
namespace {

constexpr std::size_t kKept = 32;

struct Log {
  std::atomic<std::uint64_t> count{0};
  std::mutex mutex;
  std::array<FixedText<200>, kKept> messages;  // message n is at n % kKept
};

Log& the_log() {
  static Log log;
  return log;
}

void keep(void*, const dds_log_data_t* data) {
  std::string_view text{data->message, data->size};
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.remove_suffix(1);
  Log& log = the_log();
  const std::lock_guard lock(log.mutex);
  log.messages[log.count.load() % kKept].assign(text);
  log.count.fetch_add(1);
}

}  // namespace

void install_dds_log() { dds_set_log_sink(&keep, nullptr); }

std::uint64_t dds_log_count() noexcept { return the_log().count.load(); }

std::vector<std::string> dds_log_messages() {
  Log& log = the_log();
  const std::lock_guard lock(log.mutex);
  const std::uint64_t count = log.count.load();
  std::vector<std::string> messages;
  for (std::uint64_t n = count - std::min<std::uint64_t>(count, kKept); n < count; ++n) {
    messages.emplace_back(log.messages[n % kKept].view());
  }
  return messages;
}

}  // namespace mrroc::links
