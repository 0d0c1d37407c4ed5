#pragma once

#include <functional>
#include <map>
#include <string>

#include "config/entries/program_behaviours.hpp"
#include "mrroc/message.hpp"

namespace mrroc::ecp {

namespace detail {
// true
bool enter_on(MessageSchema schema);
bool enter_tells(std::string_view label);
}  // namespace detail

/// The behaviours of one ECP program: one action for each type of message. The task's thread.
class Behaviours {
 public:
  template <MessageType B, class Handler>
  requires std::invocable<Handler, const B&>
  void on(Handler handler) {
    declare(On<B>::kEntered);
    handlers_[std::string{label_of<B>()}] = [handler = std::move(handler)](const Message& parcel) {
      handler(unpack<B>(parcel));
    };
  }
  /// Declares that the program sends messages of type M.
  template <MessageType M>
  static void tells() noexcept {
    declare(Tells<M>::kEntered);
  }

  /// Runs the behaviour of the parcel's label. Throws NonFatalError(invalid_argument) when no behaviour has this label
  /// (the message lists the labels), or its fields differ; and any exception of the behaviour.
  void run(const Message& parcel) const;

  /// The labels of the linked program's behaviours and of the messages that it sends. Any thread.
  static config::ProgramBehaviours declared();

 private:
  // entered before main, because some `on<B>`, `tells<M>` is linked
  template <MessageType B>
  struct On {
    static inline const bool kEntered = detail::enter_on(schema_of<B>());
  };
  template <MessageType M>
  struct Tells {
    static inline const bool kEntered = detail::enter_tells(label_of<M>());
  };
  static void declare(bool /*entered*/) noexcept {}

  std::map<std::string, std::function<void(const Message&)>> handlers_;
};

}  // namespace mrroc::ecp
