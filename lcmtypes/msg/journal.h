// The journal of a process that answers states: which messages it consumed, in which order, for which answer.
//
// Control depends on states, messages and instants given to it, and on nothing else; so whoever has the messages (a log)
// and this journal can compute every answer again bit for bit.  Messages are named by a hash of their bytes.

#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// content_hash word by word, forwards and back.
class HashSteps {
 public:
  explicit HashSteps(std::size_t bytes) noexcept : hash_((bytes + 1) * kPrime) {}
  // The eight bytes from here, fewer at the end.
  static std::uint64_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) noexcept {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, bytes.size() - at < 8 ? bytes.size() - at : 8);
    return word;
  }
  void take(std::uint64_t word) noexcept {
    hash_ = (hash_ ^ word) * kPrime;
    hash_ ^= hash_ >> 29;
  }
  std::uint64_t hash() const noexcept { return hash_; }
  // The hash before a step, with its word in it, from the hash after it.
  static std::uint64_t undone(std::uint64_t after) noexcept {
    return (after ^ (after >> 29) ^ (after >> 58)) * kInverse;
  }

 private:
  static constexpr std::uint64_t kPrime = 0x9e3779b97f4a7c15ULL;
  static constexpr std::uint64_t kInverse = 0xf1de83e19937733dULL;  // of kPrime, modulo 2^64
  static_assert(kPrime * kInverse == 1);
  std::uint64_t hash_;
};

// 64 bits; any changed bit changes it.
inline std::int64_t content_hash(std::span<const std::uint8_t> bytes) noexcept {
  HashSteps steps(bytes.size());
  for (std::size_t at = 0; at < bytes.size(); at += 8) steps.take(HashSteps::word_at(bytes, at));
  return static_cast<std::int64_t>(steps.hash());
}

// As what the controller's journal counts a message that is for it.
constexpr JournalInput journal_input(const ModeRequest&) { return JournalInput::kMode; }
constexpr JournalInput journal_input(const WalkCommand&) { return JournalInput::kWalk; }
constexpr JournalInput journal_input(const StepList&) { return JournalInput::kSteps; }
constexpr JournalInput journal_input(const MotionPiece&) { return JournalInput::kMotion; }
constexpr JournalInput journal_input(const Gamepad&) { return JournalInput::kGamepad; }
constexpr JournalInput journal_input(const ArmPathPiece&) { return JournalInput::kPath; }
constexpr JournalInput journal_input(const ArmGoal&) { return JournalInput::kGoal; }
constexpr JournalInput journal_input(const StopRequest&) { return JournalInput::kStop; }
constexpr JournalInput journal_input(const GuardReport&) { return JournalInput::kGuard; }
constexpr JournalInput journal_input(const ObstaclesPiece&) { return JournalInput::kObstacles; }

// Collects one page after another.  send(const JournalPage&) is called when a page is full or its answer is there.
template <class Send>
class JournalWriter {
 public:
  JournalWriter(ProcessKind kind, std::int64_t process_id, const std::array<double, 4>& setting,
                Send send) noexcept
      : send_(send) {
    page_.kind = kind;
    page_.process_id = process_id;
    page_.setting = setting;
  }

  void consumed(JournalInput input, std::span<const std::uint8_t> bytes,
                std::int64_t now_ns) noexcept {
    if (static_cast<std::size_t>(page_.inputs) == kJournalInputs) put(false);
    const auto i = static_cast<std::size_t>(page_.inputs++);
    page_.input[i] = input;
    page_.input_hash[i] = bytes.empty() ? 0 : content_hash(bytes);
    page_.input_ns[i] = now_ns;
  }

  // The step that answered, or did not answer, this state; hashes of what was sent, 0 for nothing.
  void stepped(const RobotState& state, std::int64_t state_hash, std::int64_t now_ns,
               std::int64_t answer_hash, std::int64_t report_hash) noexcept {
    page_.run_id = state.run_id;
    page_.tick = state.tick;
    page_.state_hash = state_hash;
    page_.now_ns = now_ns;
    page_.answer_hash = answer_hash;
    page_.report_hash = report_hash;
    put(true);
    ++page_.step;
  }

 private:
  void put(bool whole) noexcept {
    page_.whole = whole;
    send_(page_);
    ++page_.page;
    page_.inputs = 0;
    page_.input.fill(JournalInput::kNone);
    page_.input_hash.fill(0);
    page_.input_ns.fill(0);
    if (whole) page_.answer_hash = page_.report_hash = page_.state_hash = 0;
  }

  Send send_;
  JournalPage page_;
};

}  // namespace twinbus::lcmtypes
