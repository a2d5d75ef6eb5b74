#include "launcher/log/rerun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <span>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "launcher/bus/stack_monitor.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/handler.h"
#include "lcmtypes/bus/wire.h"
#include "viewer_log/log/log_event.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kWait =
    500'000;  // messages may be recorded behind the page that names them [us]
constexpr std::int64_t kMostPages = std::int64_t{1} << 53;
constexpr std::size_t kMostFindings = 30;
constexpr int kFewBytes = 6;           // a message that differs in no more is the same one, damaged
constexpr int kMostMends = 40;         // of messages that the log does not have
constexpr int kMostCandidates = 1000;  // messages that are tried for a flipped bit

// Channels of inputs, by JournalInput.
constexpr std::array<const char*, 14> kChannels = {"",
                                                   channel::kModeRequest,
                                                   channel::kWalk,
                                                   channel::kGamepad,
                                                   channel::kArmPath,
                                                   channel::kArmGoal,
                                                   channel::kStop,
                                                   channel::kGuard,
                                                   channel::kObstacles,
                                                   "",
                                                   channel::kCommand,
                                                   channel::kSteps,
                                                   channel::kMotion,
                                                   channel::kHeld};

bool is_needed(std::string_view name) {
  for (const char* channel : kChannels) {
    if (name == channel) return true;
  }
  return name == channel::kState || name == channel::kControllerStatus;
}

}  // namespace

void Rerun::say(const Process& process, const JournalPage& page, const std::string& sentence) {
  if (findings_.size() >= kMostFindings) return;
  findings_.push_back(std::string(process_name(process.figures.kind)) + ", tick " +
                      std::to_string(page.tick) + ": " + sentence);
}

void Rerun::add(std::string_view name, std::int64_t utime, std::span<const std::uint8_t> bytes) {
  if (name == channel::kJournal) {
    JournalPage page;
    // A count that nobody has come to is damage.
    const bool sane =
        decode(bytes, page) == Status::kOk && page.page >= 0 && page.page < kMostPages;
    if (sane) waiting_.push_back({utime, page});
  } else if (is_needed(name)) {
    store_.add(std::string(name), utime, {bytes.begin(), bytes.end()});
  }
  while (!waiting_.empty() && utime - waiting_.front().utime > kWait) {
    turn(waiting_.front().page);
    waiting_.pop_front();
  }
}

void Rerun::finish() {
  for (const Waiting& one : waiting_) turn(one.page);
  waiting_.clear();
}

std::vector<RerunFigures> Rerun::figures() const {
  std::vector<RerunFigures> all;
  for (const auto& [id, process] : processes_) all.push_back(process.figures);
  return all;
}

void Rerun::start(Process& process, const JournalPage& page) {
  process.figures.kind = page.kind;
  process.figures.id = page.process_id;
  if (page.page != 0) {
    process.figures.whole = false;
    say(process, page,
        std::string("the log begins after ").append(std::to_string(page.step)) +
            " answers of this process; it can only be computed again from its start");
  } else if (page.kind == ProcessKind::kController) {
    ControlConfig config;
    config.controller_id = page.process_id;
    config.first_mode = static_cast<Mode>(std::lround(page.setting[0]));
    config.guard_in_loop = page.setting[1] != 0.0;
    process.loop = std::make_unique<ControlLoop>(model_, config);
  } else if (page.kind == ProcessKind::kGuard) {
    process.watch = std::make_unique<GuardWatch>(
        model_, GuardConfig{.guard_id = page.process_id, .margin = page.setting[0]});
  }
}

void Rerun::turn(const JournalPage& page) {
  const auto [found, is_new] = processes_.try_emplace(page.process_id);
  Process& process = found->second;
  if (is_new) {
    start(process, page);
  } else if (process.figures.whole && page.page != process.next_page) {
    process.figures.whole = false;
    say(process, page,
        std::to_string(page.page - process.next_page) + " pages of its journal are missing");
  }
  process.next_page = page.page + 1;
  if (!process.figures.whole || (process.loop == nullptr && process.watch == nullptr)) return;
  for (std::size_t i = 0; i < at(page.inputs); ++i) consume(process, page, i);
  if (page.whole) step(process, page);
}

// The message as it was consumed; empty when the log does not have it.
std::vector<std::uint8_t> Rerun::input(Process& process, const std::string& name, std::int64_t hash,
                                       const JournalPage& page) {
  ++process.figures.inputs;
  if (const StoredMessage* message = store_.find(hash)) return message->bytes;
  std::vector<std::uint8_t> mended;
  const auto mend = [&](const StoredMessage& candidate) {
    std::size_t byte = 0;
    mended = with_one_bit_mended(candidate.bytes, hash, byte);
    if (mended.empty()) return false;
    ++process.figures.damaged;
    say(process, page,
        name + " it heard has one flipped bit in the log, byte " + std::to_string(byte) + ", " +
            first_difference(name, candidate.bytes, mended, "then"));
    return true;
  };
  // Of a state the tick is known, so what the log has can be named, and used.
  const StoredMessage* same_tick = nullptr;
  if (name == channel::kState) {
    same_tick = store_.look(name, [&](const StoredMessage& candidate) {
      constexpr std::size_t kTick = 8, kRun = 32;  // where they lie in a STATE [bytes]
      return candidate.bytes.size() > kRun + 8 &&
             read_i64(candidate.bytes.data() + kTick) == page.tick &&
             read_i64(candidate.bytes.data() + kRun) == page.run_id;
    });
  }
  int tried = 0;
  if (++mends_ <= kMostMends && (same_tick == nullptr || !mend(*same_tick))) {
    store_.look(name, [&](const StoredMessage& candidate) {
      return mend(candidate) || ++tried == kMostCandidates;
    });
  }
  if (!mended.empty()) return mended;
  ++process.figures.missing;
  say(process, page,
      same_tick != nullptr ? name + " in the log is not the one it heard"
                           : name + " it heard is not in the log");
  return same_tick != nullptr ? same_tick->bytes : std::vector<std::uint8_t>();
}

namespace {

template <auto kMethod, class Owner>
void give(const std::vector<std::uint8_t>& bytes, Owner& owner, std::int64_t now_ns) {
  MessageOf<kMethod> message;
  if (decode(bytes, message) == Status::kOk) hand_over<kMethod>(message, owner, now_ns);
}

}  // namespace

void Rerun::consume(Process& process, const JournalPage& page, std::size_t i) {
  const JournalInput kind = page.input[i];
  if (kind == JournalInput::kTakeObstacles) {
    if (process.loop != nullptr) process.loop->set_obstacles(process.obstacles.obstacles());
    if (process.watch != nullptr) process.watch->set_obstacles(process.obstacles.obstacles());
    return;
  }
  const std::vector<std::uint8_t> bytes =
      input(process, kChannels[static_cast<std::size_t>(kind)], page.input_hash[i], page);
  if (bytes.empty()) return;
  const std::int64_t now = page.input_ns[i];
  if (kind == JournalInput::kObstacles || kind == JournalInput::kHeld) {
    ObstaclesPiece piece;
    if (decode(bytes, piece) != Status::kOk) return;
    (void)(kind == JournalInput::kHeld ? process.obstacles.hold(piece) : process.obstacles.add(piece));
    return;
  }
  if (process.watch != nullptr) {
    if (kind == JournalInput::kCommand) give<&GuardWatch::on_command>(bytes, *process.watch, now);
    return;
  }
  for_each_control_input([&]<auto kOn>() {
    if (journal_input(MessageOf<kOn>{}) == kind) give<kOn>(bytes, *process.loop, now);
  });
}

void Rerun::step(Process& process, const JournalPage& page) {
  const std::vector<std::uint8_t> bytes = input(process, channel::kState.name, page.state_hash, page);
  RobotState state;
  if (bytes.empty() || decode(bytes, state) != Status::kOk) {
    process.figures.whole = false;  // from here on nothing can be the same
    return;
  }
  ++process.figures.steps;
  const std::int64_t different = process.figures.different;
  if (process.watch != nullptr) {
    ++process.figures.answers;
    compare(process, page, channel::kGuard.name, page.answer_hash, encoded(process.watch->judge(state)));
  } else {
    ControlLoop& loop = *process.loop;
    loop.on_state(state, page.now_ns);
    JointCommand command;
    const bool answered = loop.step(page.now_ns, command);
    (void)loop.take_sentence();
    // As the process does: the next stop plan is not begun before the last piece of this one is taken.
    for (StopPlanPiece piece; answered && loop.take_plan(piece);) {
    }
    if (answered != (page.answer_hash != 0)) {
      ++process.figures.different;
      say(process, page,
          answered ? "answers now, but did not then" : "does not answer now, but did then");
    } else if (answered) {
      ++process.figures.answers;
      compare(process, page, channel::kCommand.name, page.answer_hash, encoded(command));
      compare(process, page, channel::kControllerStatus.name, page.report_hash, encoded(loop.status()));
    }
  }
  if (process.figures.different > different) process.figures.different = different + 1;
}

// What is computed now with what was sent then, and with what the log says was sent.
void Rerun::compare(Process& process, const JournalPage& page, const std::string& name,
                    std::int64_t hash_then, const std::vector<std::uint8_t>& now) {
  const StoredMessage* logged = store_.find(hash_then);
  if (logged == nullptr) {
    logged = store_.look(name, [&](const StoredMessage& candidate) {
      if (candidate.bytes.size() != now.size()) return false;
      // Type, tick and run lie at the head of all three types; where those are damaged, the rest is alike.
      if (std::equal(now.begin(), now.begin() + 24, candidate.bytes.begin())) return true;
      return std::inner_product(now.begin(), now.end(), candidate.bytes.begin(), 0, std::plus<>(),
                                std::not_equal_to<>()) <= kFewBytes;
    });
    const bool same_now = content_hash(now) == hash_then;
    if (logged == nullptr) {
      ++process.figures.missing;
      say(process, page, name + " it sent is not in the log");
    } else if (same_now) {
      ++process.figures.damaged;
      say(process, page,
          name + " is damaged in the log: " +
              first_difference(name, logged->bytes, now, "when it was sent"));
    }
  }
  if (content_hash(now) == hash_then) return;
  ++process.figures.different;
  say(process, page,
      name + " is not the same: " +
          (logged != nullptr ? first_difference(name, logged->bytes, now, "now")
                             : std::string("field not known")));
}

bool is_same(const std::vector<RerunFigures>& figures) {
  return std::all_of(figures.begin(), figures.end(), [](const RerunFigures& f) {
    return f.whole && f.different == 0 && f.missing == 0 && f.damaged == 0;
  });
}

std::string rerun_verdict(const std::vector<RerunFigures>& figures) {
  if (is_same(figures)) return "bit for bit the same";
  std::int64_t different = 0, missing = 0, damaged = 0;
  bool whole = true;
  for (const RerunFigures& f : figures) {
    different += f.different;
    missing += f.missing;
    damaged += f.damaged;
    whole = whole && f.whole;
  }
  const bool lacks = missing > 0 || damaged > 0 || !whole;
  std::string lack = formatted("%lld messages are missing in the log and %lld damaged", static_cast<long long>(missing),
                               static_cast<long long>(damaged));
  if (!whole) lack += ", and it is not whole";
  if (different == 0) return "all answers that can be compared are the same; the others are NOT COMPARABLE: " + lack;
  return lacks ? "NOT the same; that may come of the log alone: " + lack : "NOT the same";
}

}  // namespace twinbus::launcher
