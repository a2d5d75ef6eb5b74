#include "viewer_log/log/shortest_number.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace twinbus::inline viewer_log {

namespace {

__extension__ using Wide = unsigned __int128;

constexpr int kLeastPower = -292, kMostPower = 324;  // of ten, that a double asks for

// 10^k = g 2^r with 2^127 <= g < 2^128, rounded down; r is floor_log2_pow10(k) - 127.
struct Powers {
  std::array<Wide, kMostPower - kLeastPower + 1> g{};

  constexpr Powers() {
    for (int sign : {1, -1}) {
      // 5^k, or 2^895 / 5^-k: rounding down at every step is rounding down once.
      std::array<std::uint64_t, 14> digits{};
      (sign > 0 ? digits.front() : digits.back()) = sign > 0 ? 1 : std::uint64_t{1} << 63;
      for (int k = 0; k >= kLeastPower && k <= kMostPower; k += sign) {
        g[static_cast<std::size_t>(k - kLeastPower)] = top(digits);
        Wide carry = 0;
        for (std::size_t i = 0; i < digits.size(); ++i) {
          std::uint64_t& digit = digits[sign > 0 ? i : digits.size() - 1 - i];
          if (sign > 0) {
            carry += Wide{digit} * 5;
            digit = static_cast<std::uint64_t>(carry);
            carry >>= 64;
          } else {
            carry = carry << 64 | digit;
            digit = static_cast<std::uint64_t>(carry / 5);
            carry %= 5;
          }
        }
      }
    }
  }

  // The upper 128 bits, the first of which is one.
  static constexpr Wide top(const std::array<std::uint64_t, 14>& digits) {
    std::size_t i = digits.size() - 1;
    while (digits[i] == 0) --i;
    const auto digit = [&](std::size_t below) { return below <= i ? digits[i - below] : 0; };
    const int shift = std::countl_zero(digits[i]);
    const Wide two = Wide{digit(0)} << 64 | digit(1);
    return shift == 0 ? two : two << shift | digit(2) >> (64 - shift);
  }
};
constexpr Powers kPowers;

constexpr int floor_log2_pow10(int k) { return (k * 1741647) >> 19; }
constexpr int floor_log10_pow2(int q) { return (q * 1262611) >> 22; }
constexpr int floor_log10_three_quarters_pow2(int q) { return (q * 1262611 - 524031) >> 22; }

// x g as an integer; its last bit says whether anything was cut off.
std::uint64_t round_to_odd(Wide g, std::uint64_t x) {
  const Wide low = Wide{static_cast<std::uint64_t>(g)} * x;
  const Wide sum = (g >> 64) * x + (low >> 64);
  return static_cast<std::uint64_t>(sum >> 64) | (static_cast<std::uint64_t>(sum) > 1 ? 1U : 0U);
}
std::uint32_t round_to_odd(std::uint64_t g, std::uint32_t x) {
  const Wide product = Wide{g} * x;
  return static_cast<std::uint32_t>(product >> 64) |
         (static_cast<std::uint32_t>(product >> 32) > 1 ? 1U : 0U);
}

template <class Number>
struct Layout;
template <>
struct Layout<double> {
  using Bits = std::uint64_t;
  static constexpr int kFraction = 52, kOffset = 1075, kDigits = 17;
  static Wide power(int k) { return kPowers.g[static_cast<std::size_t>(k - kLeastPower)] + 1; }
};
template <>
struct Layout<float> {
  using Bits = std::uint32_t;
  static constexpr int kFraction = 23, kOffset = 150, kDigits = 9;
  static std::uint64_t power(int k) {
    return static_cast<std::uint64_t>(kPowers.g[static_cast<std::size_t>(k - kLeastPower)] >> 64) +
           1;
  }
};

// One of two without a branch.
template <class Bits>
Bits choose(bool first, Bits one, Bits other) {
  return other ^ ((one ^ other) & (Bits{0} - Bits{first}));
}

template <class Bits>
struct Decimal {
  Bits digits;
  int exponent;
};

// The number is c 2^q, positive.  Names as in the paper.
template <class Number, class Bits = typename Layout<Number>::Bits>
Decimal<Bits> shortest(Bits fraction, int exponent) {
  constexpr Bits kHidden = Bits{1} << Layout<Number>::kFraction;
  const Bits c = exponent > 0 ? fraction | kHidden : fraction;
  const int q = std::max(exponent, 1) - Layout<Number>::kOffset;
  const bool is_even = c % 2 == 0;
  const bool closer_below = fraction == 0 && exponent > 1;  // the next smaller is half as far
  const int k = closer_below ? floor_log10_three_quarters_pow2(q) : floor_log10_pow2(q);
  const int h = q + floor_log2_pow10(-k) + 1;
  const auto g = Layout<Number>::power(-k);
  const Bits vbl = round_to_odd(g, static_cast<Bits>((4 * c - 2 + (closer_below ? 1 : 0)) << h));
  const Bits vb = round_to_odd(g, static_cast<Bits>((4 * c) << h));
  const Bits vbr = round_to_odd(g, static_cast<Bits>((4 * c + 2) << h));
  const Bits lower = vbl + (is_even ? 0 : 1), upper = vbr - (is_even ? 0 : 1);
  const Bits s = vb / 4;
  // One digit less, else the neighbours s and s + 1, else the nearest; without branches, which nobody could foresee.
  const Bits shorter = s / 10;
  const bool shorter_below = lower <= 40 * shorter, shorter_above = 40 * shorter + 40 <= upper;
  const bool below = lower <= 4 * s, above = 4 * s + 4 <= upper;
  const Bits middle = 4 * s + 2;
  const bool nearer = (vb > middle) | ((vb == middle) & (s % 2 != 0));
  const Bits as_long = s + choose<Bits>(below != above, above, nearer);
  const bool is_shorter = (s >= 10) & (shorter_below != shorter_above);
  return {choose<Bits>(is_shorter, shorter + shorter_above, as_long), k + is_shorter};
}

constexpr std::uint64_t kZeros = 0x3030303030303030;  // the text "00000000"

constexpr auto kTens = [] {
  std::array<std::uint64_t, 20> tens{1};
  for (std::size_t i = 1; i < tens.size(); ++i) tens[i] = 10 * tens[i - 1];
  return tens;
}();

// Eight digits, one per byte, the first in the lowest: all at once by dividing parts of a word.
std::uint64_t eight_digits(std::uint64_t value) {
  const std::uint64_t fours = value / 10000 | (value % 10000) << 32;
  const std::uint64_t hundreds = (fours * 10486 >> 20) & 0x0000007f0000007f;
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16;
  const std::uint64_t tens = (twos * 103 >> 10) & 0x000f000f000f000f;
  return tens | (twos - 10 * tens) << 8;
}

void put_word(char* out, std::uint64_t word) {
  static_assert(std::endian::native == std::endian::little);
  std::memcpy(out, &word, sizeof word);
}

// digits 10^exponent, digits > 0; fixed where that is not longer than with an exponent.  What lies behind the end is
// written over, so that every copy has a known length.
template <int kMostDigits>  // 17 of a double, 9 of a float
char* write_decimal(char* out, std::uint64_t digits, int exponent) {
  constexpr bool kLong = kMostDigits > 9;
  // As many digits as there can be, the first one by itself; those that are zeros at the end do not count.
  int count =
      (64 - std::countl_zero(digits)) * 1233 >> 12;  // log10 from log2, at most one too small
  count += digits >= kTens[static_cast<std::size_t>(count)] ? 1 : 0;
  const int power = exponent + count - 1;  // of the first digit
  digits *= kTens[static_cast<std::size_t>(kMostDigits - count)];
  const std::uint64_t upper = kLong ? digits / kTens[8] : digits, first = upper / kTens[8];
  const std::uint64_t left = eight_digits(upper - first * kTens[8]);
  const std::uint64_t right = kLong ? eight_digits(digits - upper * kTens[8]) : 0;
  count = right != 0  ? 17 - std::countl_zero(right) / 8
          : left != 0 ? 9 - std::countl_zero(left) / 8
                      : 1;
  const char letter = static_cast<char>('0' + first);

  const int scientific = count + (count > 1 ? 1 : 0) + (std::abs(power) >= 100 ? 5 : 4);
  const int fixed = power < 0 ? count + 1 - power : std::max(count + 1, power + 1);
  if (fixed - (power == count - 1 ? 1 : 0) > scientific) {
    out[0] = letter;
    out[1] = '.';
    put_word(out + 2, left | kZeros);
    if (kLong) put_word(out + 10, right | kZeros);
    out += count > 1 ? count + 1 : 1;
    const int size = std::abs(power);
    *out++ = 'e';
    *out++ = power < 0 ? '-' : '+';
    if (size >= 100) *out++ = static_cast<char>('0' + size / 100);
    *out++ = static_cast<char>('0' + size / 10 % 10);
    *out++ = static_cast<char>('0' + size % 10);
    return out;
  }
  if (power < 0) {  // 0.00123; more zeros would be longer than an exponent
    put_word(out, kZeros);
    out[1] = '.';
    out += 1 - power;
  }
  out[0] = letter;
  put_word(out + 1, left | kZeros);
  if (kLong) put_word(out + 9, right | kZeros);
  if (power < 0) return out + count;
  if (power >= count - 1) return out + power + 1;
  const Wide rest = (Wide{right | kZeros} << 64 | (left | kZeros)) >> (8 * power);
  out[power + 1] = '.';
  put_word(out + power + 2, static_cast<std::uint64_t>(rest));
  if (kLong) put_word(out + power + 10, static_cast<std::uint64_t>(rest >> 64));
  return out + count + 1;
}

template <class Number>
char* write_number(char* out, Number value) noexcept {
  using Bits = typename Layout<Number>::Bits;
  constexpr int kFraction = Layout<Number>::kFraction;
  const auto bits = std::bit_cast<Bits>(value);
  const Number size = std::fabs(value);
  // Beyond, every digit before the point is written, also those that reading back does not need.
  if (!(size < static_cast<Number>(Bits{1} << kFraction)))
    return std::to_chars(out, out + kLongestNumber, value).ptr;
  *out = '-';
  out += std::signbit(value) ? 1 : 0;
  if (size == 0) {
    *out++ = '0';
    return out;
  }
  const Bits fraction = bits & ((Bits{1} << kFraction) - 1);
  const int exponent = static_cast<int>(bits << 1 >> (kFraction + 1));
  const auto [digits, power] = shortest<Number>(fraction, exponent);
  return write_decimal<Layout<Number>::kDigits>(out, digits, power);
}

}  // namespace

char* write_shortest(char* out, double value) noexcept { return write_number(out, value); }
char* write_shortest(char* out, float value) noexcept { return write_number(out, value); }

}  // namespace twinbus::viewer_log
