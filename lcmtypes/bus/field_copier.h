// Copies the fields of a message one way and judges each; the .lcm files list the fields, this knows the rules.
//
// Only convert.cpp includes it.

#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "common/text/printable.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline lcmtypes {

inline constexpr double kLargestNumber = 1e12;  // in any SI unit; its square still fits a float
inline constexpr std::int64_t kIds = std::int64_t{1} << 53;
inline constexpr std::int64_t kInstants = std::int64_t{1}
                                          << 62;  // [ns, us] differences do not overflow
inline constexpr std::int32_t kCounts =
    std::int32_t{1} << 30;  // terms and sequences: adding to them does not overflow

// Copies fields one way and judges what it copied.  The first objection stays.
template <bool to_message>
class Copier {
 public:
  Status status() const noexcept { return status_; }

  // A number, a flag, an enumeration, or an array of them.
  template <class M, class S>
  void operator()(M& m, S& s) noexcept {
    if constexpr (std::is_array_v<M>) {
      for (std::size_t i = 0; i < std::extent_v<M>; ++i) (*this)(m[i], s[i]);
    } else {
      using Field = std::remove_const_t<S>;
      if constexpr (std::is_enum_v<Field>) {
        if (!(m_value(m, s) >= 0 && m_value(m, s) <= last_of(Field{}))) refuse(Status::kOutOfRange);
      } else if constexpr (std::is_same_v<Field, bool>) {
        if (!(m_value(m, s) == 0 || m_value(m, s) == 1)) refuse(Status::kOutOfRange);
      } else if constexpr (std::is_floating_point_v<Field>) {
        const auto x = m_value(m, s);
        if (!std::isfinite(x)) refuse(Status::kNotFinite);
        if (!(std::abs(x) <= static_cast<decltype(x)>(kLargestNumber))) refuse(Status::kOutOfRange);
      }
      copy(m, s);
    }
  }

  // A number, or an array of them, that must lie in low .. high.
  template <class M, class S, class Low, class High>
  void within(M& m, S& s, Low low, High high) noexcept {
    (*this)(m, s);
    judge(s, low, high);
  }
  template <class S, class Low, class High>
  void judge(const S& s, Low low, High high) noexcept {
    if constexpr (std::is_arithmetic_v<S>) {
      if (!(s >= low && s <= high)) refuse(Status::kOutOfRange);
    } else {
      for (const auto& x : s) judge(x, low, high);
    }
  }
  template <class M, class S>
  void id(M& m, S& s) noexcept {
    within(m, s, std::int64_t{0}, kIds - 1);
  }
  template <class M, class S>
  void instant(M& m, S& s) noexcept {
    within(m, s, std::int64_t{0}, kInstants);
  }
  template <class M, class S>
  void counter(M& m, S& s) noexcept {
    within(m, s, std::int32_t{0}, kCounts);
  }
  // How many entries of an array are in use.
  template <class M, class S>
  void count(M& m, S& s, int most) noexcept {
    if (!(m_value(m, s) >= 0 && m_value(m, s) <= most)) refuse(Status::kWrongSize);
    copy(m, s);
  }
  template <class M, class S>
  void joint_count(M& m, S& s) noexcept {
    count(m, s, kMaxJoints);
  }
  // Entries beyond used come out as zero.
  template <class M, class S>
  void per_joint(M& m, S& s, int used) noexcept {
    (*this)(m, s);
    for (int i = used < 0 ? 0 : used; i < kMaxJoints; ++i) {
      if constexpr (to_message)
        m[i] = 0;
      else
        s[static_cast<std::size_t>(i)] = 0;
    }
  }
  template <class M, class S>
  void rotation(M& m, S& s) noexcept {
    (*this)(m, s);
    require_rotation(s);
  }
  template <class S>
  void require_rotation(const S& quaternion) noexcept {
    double square = 0;
    for (const auto x : quaternion) square += static_cast<double>(x) * static_cast<double>(x);
    require(std::abs(square - 1.0) <= 0.01);
  }
  // Zero-terminated, for people: what is not printable becomes '?', so that no text can drive a terminal.
  template <class M, class S>
  void text(M& m, S& s) noexcept {
    bool ended = false;
    std::size_t length = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      copy(m[i], s[i]);
      const char c = s[i];
      ended = ended || c == '\0';
      if (!ended) {
        ++length;
        continue;
      }
      if constexpr (to_message) {
        m[i] = 0;
      } else {
        s[i] = '\0';
      }
    }
    if (!ended) refuse(Status::kWrongSize);
    if constexpr (to_message) {
      make_printable(reinterpret_cast<char*>(&m[0]), length);
    } else {
      make_printable(s.data(), length);
    }
  }
  void require(bool condition) noexcept {
    if (!condition) refuse(Status::kOutOfRange);
  }

 private:
  template <class M, class S>
  static auto m_value(const M& m, const S& s) noexcept {
    if constexpr (!to_message)
      return m;
    else
      return static_cast<M>(s);
  }
  template <class M, class S>
  static void copy(M& m, S& s) noexcept {
    if constexpr (to_message)
      m = static_cast<M>(s);
    else
      s = static_cast<S>(m);
  }
  void refuse(Status why) noexcept {
    if (status_ == Status::kOk) status_ = why;
  }

  Status status_ = Status::kOk;
};

template <class S, class T>
concept Is = std::same_as<std::remove_const_t<S>, T>;

}  // namespace twinbus::lcmtypes
