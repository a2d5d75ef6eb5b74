// What a receiver keeps of a channel: the newest admitted message, or the newest of each sender.
//
// A message is judged before it can replace a good one, so an intruder can neither hide nor replace
// the state.

#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "lcmtypes/bus/missing_messages.h"
#include "lcmtypes/bus/wire.h"

namespace twinbus::inline lcmtypes {

enum class Verdict : std::int8_t { kTaken, kRepeated, kRejected };

template <class T>
struct Latest {
  T message{};
  bool fresh = false;            // not taken yet
  std::int64_t received_ns = 0;  // steady clock; 0: nothing received yet
  std::int64_t received = 0;     // messages accepted so far
  std::int64_t rejected = 0;  // wrong size, type or numbers, older than the last, or not admitted
  std::int64_t lost = 0;      // gaps in the count of one sender
  std::int64_t repeated = 0;  // the same count of the same sender again

  // The receiver's own rule, asked after the message has been found whole, finite and newer.
  // Object: a function object bool(const T& candidate, const T& current) noexcept that outlives
  // this.
  template <class Object>
  void admit_by(Object& object) noexcept {
    rule_object_ = const_cast<std::remove_const_t<Object>*>(&object);
    rule_ = [](void* rule, const T& candidate, const T& current) noexcept -> bool {
      return (*static_cast<Object*>(rule))(candidate, current);
    };
  }

  // Copies the message out once.
  bool take(T& out) noexcept {
    if (!fresh) return false;
    fresh = false;
    out = message;
    return true;
  }

  // [s] since the last accepted message; very large if there was none.
  double age(std::int64_t now_ns) const noexcept {
    return received_ns == 0 ? 1e9 : 1e-9 * static_cast<double>(now_ns - received_ns);
  }

  Verdict offer(const T& candidate, std::int64_t now_ns) noexcept {
    std::int64_t step_on = 0;
    if constexpr (Wire<T>::kCounted) {
      if (received > 0 && Wire<T>::sender(candidate) == Wire<T>::sender(message)) {
        const std::int64_t step = Wire<T>::count(candidate) - Wire<T>::count(message);
        if (step == 0) {
          ++repeated;
          return Verdict::kRepeated;
        }
        if (step < 0) return reject();
        step_on = step;
      }
    }
    if (rule_ != nullptr && !rule_(rule_object_, candidate, message)) return reject();
    lost += missing_.after(step_on);  // 0: another sender
    message = candidate;
    received_ns = now_ns;
    fresh = true;
    ++received;
    return Verdict::kTaken;
  }

 private:
  Verdict reject() noexcept {
    ++rejected;
    return Verdict::kRejected;
  }

  MissingMessages missing_;
  bool (*rule_)(void*, const T&, const T&) noexcept = nullptr;
  void* rule_object_ = nullptr;
};

// One Latest per sender; a sender silent for 5 s gives its slot to a new one when there is no room.
template <class T, int N = 16>
struct Slots {
  std::array<Latest<T>, N> slots;
  std::int64_t rejected = 0;  // wrong size, type or numbers, or no slot left

  // Null when nothing has been heard of this sender.
  const Latest<T>* find(std::int64_t sender) const noexcept {
    for (const Latest<T>& slot : slots) {
      if (slot.received > 0 && Wire<T>::sender(slot.message) == sender) return &slot;
    }
    return nullptr;
  }

  Verdict offer(const T& candidate, std::int64_t now_ns) noexcept {
    Latest<T>* chosen = nullptr;
    for (Latest<T>& slot : slots) {
      if (slot.received == 0 || Wire<T>::sender(slot.message) == Wire<T>::sender(candidate)) {
        chosen = &slot;
        break;
      }
    }
    if (chosen == nullptr) {
      for (Latest<T>& slot : slots) {
        if (slot.age(now_ns) > kForgotten) {
          chosen = &slot;
          *chosen = {};
          break;
        }
      }
    }
    if (chosen == nullptr) {
      ++rejected;
      return Verdict::kRejected;
    }
    return chosen->offer(candidate, now_ns);
  }

 private:
  static constexpr double kForgotten = 5.0;  // [s]
};

}  // namespace twinbus::lcmtypes
