// What Bus::listen calls with each message: an object that can be called, or a method of one.

#pragma once

#include <cstdint>
#include <type_traits>

namespace twinbus::inline lcmtypes {

// The message that a method hears: T of void f(const T&, ...).
template <class Method>
struct HeardBy;
template <class Owner, class T, class... More>
struct HeardBy<void (Owner::*)(const T&, More...)> {
  using Message = T;
};
template <class Owner, class T, class... More>
struct HeardBy<void (Owner::*)(const T&, More...) noexcept> {
  using Message = T;
};
template <auto kMethod>
using MessageOf = typename HeardBy<decltype(kMethod)>::Message;

// Hands the message to that method, with the time where it takes one.
template <auto kMethod, class Owner>
void hand_over(const MessageOf<kMethod>& message, Owner& owner, std::int64_t now_ns) {
  if constexpr (std::is_invocable_v<decltype(kMethod), Owner&, const MessageOf<kMethod>&, std::int64_t>) {
    (owner.*kMethod)(message, now_ns);
  } else {
    (owner.*kMethod)(message);
  }
}

// An object that is called itself.
struct CallItself {
  template <class Handler, class... With>
    requires std::is_invocable_v<Handler&, const With&...>
  void operator()(Handler& handler, const With&... with) const {
    handler(with...);
  }
};

}  // namespace twinbus::lcmtypes
