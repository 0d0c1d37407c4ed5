#pragma once

#include <filesystem>
#include <string>

#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::edp {

/// From now on a crash inside a call into the driver is named: the standard error gets "driver 'ur' (PATH) crashed in
/// read (signal 11)", then the process ends with that signal. So does an exception that leaves a function which
/// promises none. A handler that another has installed (a sanitizer's, a debugger's) stays. Main thread, once.
void name_crashes_of(const std::string& driver, const std::filesystem::path& library);

/// Marks the time of a call into the driver, for its thread. Real-time; nests.
class DriverCall {
 public:
  /// `name` must outlive it.
  explicit DriverCall(const char* name) noexcept;
  ~DriverCall();
  DriverCall(const DriverCall&) = delete;
  DriverCall& operator=(const DriverCall&) = delete;

 private:
  const char* before_;
};

/// Calls a function of the driver that may throw. Errors of the framework pass; others become
/// SystemError(configuration) with the driver's name.
template <class Call>
auto call_driver(const std::string& driver, const char* name, const Call& function) {
  const DriverCall call(name);
  try {
    return function();
  } catch (const Error&) {
    throw;
  } catch (const config::ConfigurationError&) {
    throw;
  } catch (const std::exception& error) {
    throw SystemError(ErrorCode::configuration, "driver '" + driver + "': " + error.what());
  } catch (...) {
    throw SystemError(ErrorCode::configuration, "driver '" + driver + "': an exception that is not a std::exception");
  }
}

}  // namespace mrroc::edp
