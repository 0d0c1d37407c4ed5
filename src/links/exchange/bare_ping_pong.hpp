#pragma once

#include <memory>
#include <string>

#include "links/transport/domain.hpp"

namespace mrroc::links {

// What an exchange costs with nothing of ours around it: Cyclone's C API, a listener given at the reader's creation,
// and a futex that wakes the thread that takes. The yardstick of bench/link_roundtrip; no process of a deployment uses
// it. The messages are those of a command and of a state (messages.idl), with the links' own domain and QoS.

/// Asks. One thread calls it.
class BarePing {
 public:
  /// Topics `<prefix>/command` and `<prefix>/state`. Throws SystemError as `Writer` and `Reader` do.
  BarePing(Domain& domain, const std::string& prefix);
  ~BarePing();

  /// Exchanges until one has succeeded, for about `timeout` s. Throws SystemError (link_lost).
  void connect(double timeout);
  /// Writes one command and waits for the state that answers it. Throws SystemError (link_lost) after 20 s.
  void exchange();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Answers every command with a state, until it is destroyed.
class BareEcho {
 public:
  enum class Where {
    thread,   ///< a thread of its own, which the listener wakes: as an application does
    listener  ///< Cyclone's receive thread: one hand-over less
  };
  BareEcho(Domain& domain, const std::string& prefix, Where where);
  ~BareEcho();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
