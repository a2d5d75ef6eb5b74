// What Bus::listen_each calls with each message: an object that can be called, or a method of one.

#pragma once

#include <type_traits>

namespace twinbus {

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

// An object that is called itself.
struct CallItself {
  template <class Handler, class... With>
    requires std::is_invocable_v<Handler&, const With&...>
  void operator()(Handler& handler, const With&... with) const {
    handler(with...);
  }
};

}  // namespace twinbus
