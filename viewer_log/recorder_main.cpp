// The recorder process: everything on the bus into a log that explains itself, and the GAP between two sources.
//
// It never waits for a disk (recorder.h) and ends before a controller does when memory runs out.

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/process/oom_priority.h"
#include "common/process/options.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "common/text/formatted.h"
#include "common/time/time_name.h"
#include "lcmtypes/bus/node.h"
#include "viewer_log/log/log_writer.h"
#include "viewer_log/log/message_schema.h"
#include "viewer_log/log/recorder.h"
#include "viewer_log/view/gap_meter.h"

namespace twinbus::inline viewer_log {
namespace {

constexpr double kWait = 0.02;                   // [s]
constexpr std::int64_t kGapEvery = 100'000'000;  // [ns]
constexpr int kQueue = 1 << 16;                  // messages
constexpr char kSplit[] = "500MB";
constexpr double kQuota = 10.0;                 // unless something else is asked for [GB]
constexpr double kKeep = 30.0;                  // [min]
constexpr std::int64_t kMostDelay = 5'000'000;  // a message may have waited for us [us]
// Kinds of LOG_TEXT beyond those of MODEL_TEXT.
constexpr std::int8_t kStackText = 5, kAboutText = 6, kSchemaText = 7;

struct Arguments {
  CommonOptions common;
  std::string file, output, channels = ".*", split = kSplit, folder;
  double quota_gb = kQuota, keep_min = kKeep;
  bool force = false;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  Options options("twinbus_recorder",
                  "Records the bus into a log that lcm-logplayer and ./twinbus log read.");
  options.positional("FILE", a.file, false, "the log; default twinbus-DATE-TIME.log");
  options.text("--output", "FILE", a.output, "the same; -o of ./twinbus record");
  options.text("--channels", "RE", a.channels, "only channels that match this regular expression");
  options.text("--split", "N[MB|min]", a.split,
               "a new part (FILE-0002 ...) after so many megabytes or minutes, default 500MB; 0: "
               "never.  Every tool "
               "takes FILE for all its parts");
  options.number("--quota", "GB", a.quota_gb, 0.0, 1e6,
                 "of all parts: removes the oldest; default 10, 0: none");
  options.number("--keep", "MIN", a.keep_min, 0.0, 1e6,
                 "the last minutes stay whatever the quota says; default 30, 0 with a --quota");
  options.flag("--force", a.force, "writes over a log that is there, with its parts");
  options.text("--run-folder", "DIR", a.folder,
               "whose stack.yaml and commit go into the log; one that is there goes on, in a new part");
  add_common(options, a.common);
  options.parse(argc, argv);
  if (options.given("--quota") && !options.given("--keep")) a.keep_min = 0.0;
  return a;
}

// Throws std::runtime_error for what is neither megabytes nor minutes.
void read_split(const std::string& text, RecorderConfig& config) {
  if (text.empty() || text == "0") return;
  std::size_t used = 0;
  double number = 0.0;
  try {
    number = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  if (used == 0 || !(number > 0.0) || !(number < 1e9) ||
      (unit != "" && unit != "MB" && unit != "min")) {
    throw std::runtime_error("--split " + text + ": say how much, as in 500MB or 10min");
  }
  if (unit == "min") {
    config.split_seconds = 60.0 * number;
  } else {
    config.split_bytes = static_cast<std::int64_t>(1e6 * number);
  }
}

std::string text_of_file(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string default_file() { return std::string("twinbus-") += time_name() += ".log"; }

RecorderConfig config_of(const Arguments& a) {
  RecorderConfig config;
  config.file = !a.output.empty() ? a.output : !a.file.empty() ? a.file : default_file();
  read_split(a.split, config);
  config.quota_bytes = static_cast<std::int64_t>(1e9 * a.quota_gb);
  config.keep_seconds = 60.0 * a.keep_min;
  config.goes_on = !a.folder.empty() && !a.force;
  return config;
}

// "at most 10 GB, and at least the last 30 minutes"
std::string limits_text(const RecorderConfig& config) {
  if (config.quota_bytes == 0) return "no limit";
  std::string limits = formatted("at most %g GB", 1e-9 * static_cast<double>(config.quota_bytes));
  if (config.keep_seconds > 0.0) {
    limits += formatted(", but always the last %g minutes", config.keep_seconds / 60.0);
  }
  return limits;
}

void add_pieces(std::string_view text, std::int8_t kind,
                std::vector<std::vector<std::uint8_t>>& messages) {
  const std::size_t pieces = (text.size() + kModelTextBytes - 1) / kModelTextBytes;
  for (std::size_t i = 0; i < pieces; ++i) {
    ModelTextPiece piece;
    piece.utime = wall_us();
    piece.size = static_cast<std::int32_t>(text.size());
    piece.piece = static_cast<std::int16_t>(i);
    piece.pieces = static_cast<std::int16_t>(pieces);
    piece.kind = kind;
    const std::string_view part = text.substr(i * kModelTextBytes, kModelTextBytes);
    piece.count = static_cast<std::int16_t>(part.size());
    std::copy(part.begin(), part.end(), piece.text.begin());
    messages.push_back(encoded(piece));
  }
}

class RecorderProcess {
 public:
  RecorderProcess(const Arguments& a, const RecorderConfig& config)
      : prefix_(a.common.prefix),
        all_channels_(a.channels == ".*"),
        recorder_(config),
        node_(a.common, ProcessKind::kLog) {
    std::vector<std::vector<std::uint8_t>> messages;
    std::string commit = text_of_file(a.folder + "/commit");
    if (commit.empty()) commit = "unknown\n";
    const std::string about = "recorder: 1\nrobot: " + a.common.robot +
                              "\nprefix: " + a.common.prefix + "\nchannels: " + a.channels +
                              "\ncommit: " + commit;
    add_pieces(about, kAboutText, messages);
    if (!a.folder.empty()) add_pieces(text_of_file(a.folder + "/stack.yaml"), kStackText, messages);
    add_pieces(schema_texts(), kSchemaText, messages);
    recorder_.describe(prefix_ + channel::kLogText, std::move(messages));
    bus_.listen_raw(("(" + a.channels + ")").c_str(), on_message_, kQueue);
    bus_.listen<&GapMeter::on_active>(channel::kState, meter_);
    for (const Channel<RobotState>& name : {channel::kStateSim, channel::kStateBridge, channel::kStateReplay}) {
      bus_.listen<&GapMeter::on_other>(name, meter_);
    }
    dropped_before_ = bus_.dropped_datagrams();  // what came before it listened is not lost
  }

  const std::string& file() const { return recorder_.first_file(); }

  void run() {
    while (!quit_requested()) {
      node_.receive(kWait);
      const std::int64_t now = monotonic_ns();
      if (now - gap_ns_ >= kGapEvery && meter_.take(gap_)) {
        gap_ns_ = now;
        gap_.utime = wall_us();
        node_.send(channel::kGap, gap_);
      }
      if (node_.pulse().due(now)) send_heartbeat();
    }
    const RecorderFigures f = recorder_.figures();
    std::printf("recorder: %lld events, %.1f MB in %d parts, %lld dropped\n",
                static_cast<long long>(f.written), 1e-6 * static_cast<double>(f.bytes), f.parts,
                static_cast<long long>(lost()));
  }

 private:
  // What a disk or a full socket cost; with a choice of channels the kernel also counts those not chosen.
  std::int64_t lost() const {
    return recorder_.figures().dropped +
           (all_channels_ ? bus_.dropped_datagrams() - dropped_before_ : 0);
  }

  // Times in a log go forward even when the clock on the wall is set.
  std::int64_t log_time(std::int64_t received_us) {
    const std::int64_t waited = std::clamp<std::int64_t>(wall_us() - received_us, 0, kMostDelay);
    const std::int64_t time = start_us_ + (monotonic_ns() - start_ns_) / 1000 - waited;
    newest_us_ = std::max(newest_us_, time);
    return newest_us_;
  }

  void hear(const char* channel, std::span<const std::uint8_t> bytes, std::int64_t wall_time_us) {
    name_.assign(prefix_);
    name_ += channel;
    recorder_.add(log_time(wall_time_us), name_, bytes);
    node_.pulse().tick(monotonic_ns(), 0);
  }

  void send_heartbeat() {
    Heartbeat& beat = node_.beat();
    beat.messages_lost = lost();
    node_.send_heartbeat(beat);
    const std::string news = recorder_.take_news();
    if (!news.empty()) tell(news);
  }

  void tell(const std::string& sentence) {
    std::fprintf(stderr, "recorder: %s\n", sentence.c_str());
    node_.tell(2, sentence.c_str());
  }

  struct OnMessage {
    RecorderProcess* p;
    void operator()(const char* channel, std::span<const std::uint8_t> bytes,
                    std::int64_t at) const {
      p->hear(channel, bytes, at);
    }
  };

  std::string prefix_, name_;
  bool all_channels_;
  Recorder recorder_;
  Node node_;
  Bus& bus_ = node_.bus();
  GapMeter meter_;
  Gap gap_;
  const std::int64_t start_us_ = wall_us(), start_ns_ = monotonic_ns();
  std::int64_t newest_us_ = 0, gap_ns_ = 0, dropped_before_ = 0;
  OnMessage on_message_{this};
};

int run(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  catch_quit_signals();
  end_first_without_memory();
  give_way();  // without FIFO priority it is the first that waits
  go_ahead_of_ordinary_programs();
  const RecorderConfig config = config_of(a);
  if (!a.force && a.folder.empty()) refuse_if_there(config.file);
  RecorderProcess process(a, config);
  std::printf("recorder ready: %s (%s)\n", process.file().c_str(), limits_text(config).c_str());
  process.run();
  return 0;
}

}  // namespace
}  // namespace twinbus::viewer_log

int main(int argc, char** argv) { return twinbus::run_process("recorder", twinbus::run, argc, argv); }
