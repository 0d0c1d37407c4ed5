#include "edp/drivers/driver_calls.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace mrroc::edp {

namespace {

// a signal handler reaches nothing else; written before the handler is installed
std::array<char, 512> crashing_driver{};

/// The call under way of this thread; null: none.
thread_local const char* call_under_way = nullptr;

/// Writes with what a signal handler may call, then ends the process with the same signal.
void on_crash(int number) {
  const char* const call = call_under_way;
  const auto write_text = [](const char* text) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
  };
  if (call != nullptr) {
    const std::array<char, 3> digits{static_cast<char>('0' + number / 10), static_cast<char>('0' + number % 10), '\0'};
    write_text(crashing_driver.data());
    write_text(" crashed in ");
    write_text(call);
    write_text(" (signal ");
    write_text(digits[0] == '0' ? digits.data() + 1 : digits.data());
    write_text(")\n");
  }
  ::signal(number, SIG_DFL);
  ::raise(number);
}

}  // namespace

DriverCall::DriverCall(const char* name) noexcept : before_(call_under_way) { call_under_way = name; }
DriverCall::~DriverCall() { call_under_way = before_; }

void name_crashes_of(const std::string& driver, const std::filesystem::path& library) {
  std::snprintf(crashing_driver.data(), crashing_driver.size(), "driver '%s' (%s)", driver.c_str(), library.c_str());
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    struct sigaction present {};
    if (::sigaction(number, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) continue;
    struct sigaction action {};
    action.sa_handler = on_crash;
    action.sa_flags = SA_NODEFER;
    ::sigaction(number, &action, nullptr);
  }
}

}  // namespace mrroc::edp
