#pragma once

#include <memory>
#include <string>

#include "links/transport/domain.hpp"

namespace mrroc::links {

// An exchange without the framework: Cyclone's C API, a listener given at the reader's creation, and a futex that wakes
// the taking thread. The reference of bench/link_roundtrip; no process of a deployment uses it. The messages are those
// of a command and of a state (messages.idl), with the links' own domain and QoS.

/// The requesting side. One thread calls it.
class BarePing {
 public:
  /// Topics `<prefix>/command` and `<prefix>/state`. Throws SystemError as `Writer` and `Reader` do.
  BarePing(Domain& domain, const std::string& prefix);
  ~BarePing();

  /// Repeats exchanges until one succeeds, for about `timeout` s. Throws SystemError (link_lost).
  void connect(double timeout);
  /// Writes one command and waits for the state that answers it. Throws SystemError (link_lost) after 20 s.
  void exchange();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Replies to every command with a state, until it is destroyed.
class BareEcho {
 public:
  enum class Where {
    thread,   ///< its own thread, which the listener wakes, as in an application
    listener  ///< Cyclone's receive thread: one thread switch less
  };
  BareEcho(Domain& domain, const std::string& prefix, Where where);
  ~BareEcho();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mrroc::links
