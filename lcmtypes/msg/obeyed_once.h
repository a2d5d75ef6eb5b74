// Which messages have been obeyed: a one-shot message is obeyed once, though it is heard again, from the network or from a
// log of the same run.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace twinbus::inline lcmtypes {

// The highest sequence of each sender; of more than N senders the one that was new first is forgotten.  Sender 0 is nobody's
// and not remembered.
template <std::size_t N>
class SenderSequences {
 public:
  // Is the sequence above the last of this sender?  Then it is the last.
  bool is_new(std::int64_t sender, std::int32_t sequence) noexcept {
    return take(sender, sequence, false);
  }
  // The same for streams, which may say the last one again.
  bool is_not_older(std::int64_t sender, std::int32_t sequence) noexcept {
    return take(sender, sequence, true);
  }

 private:
  bool take(std::int64_t sender, std::int32_t sequence, bool same_counts) noexcept {
    if (sender == 0) return true;
    for (Sender& known : senders_) {
      if (known.id != sender) continue;
      if (sequence < known.sequence || (sequence == known.sequence && !same_counts)) return false;
      known.sequence = sequence;
      return true;
    }
    senders_[next_] = {sender, sequence};
    next_ = (next_ + 1) % N;
    return true;
  }

  struct Sender {
    std::int64_t id = 0;
    std::int32_t sequence = 0;
  };
  std::array<Sender, N> senders_{};
  std::size_t next_ = 0;
};

// The last N numbers that were spent, of paths and goals, which are drawn at random.
template <std::size_t N>
class SpentNumbers {
 public:
  bool contains(std::int64_t number) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (numbers_[i] == number) return true;
    }
    return false;
  }
  void spend(std::int64_t number) noexcept {
    if (contains(number)) return;
    numbers_[next_] = number;
    next_ = (next_ + 1) % N;
    if (count_ < N) ++count_;
  }

 private:
  std::array<std::int64_t, N> numbers_{};
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace twinbus::lcmtypes
