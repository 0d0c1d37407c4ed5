#pragma once

namespace mrroc::process {

/// A descriptor that becomes readable when the process is asked to end: SIGTERM, SIGINT, SIGHUP. From now on they end
/// no thread that this one starts. Call it before any thread is started.
int stop_signals() noexcept;

}  // namespace mrroc::process
