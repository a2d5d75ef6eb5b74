// The log viewer process: recordings in the page of the viewer, to be scrubbed, stepped and laid over each other.
//
// It opens no bus, so nothing that a page asks for can reach a robot.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/description/load.h"
#include "common/file/beside_program.h"
#include "common/process/options.h"
#include "common/process/priority.h"
#include "common/process/process.h"
#include "common/process/ticker.h"
#include "viewer_log/view/frame.h"
#include "viewer_log/view/log_feed_main.h"
#include "viewer_log/log/log_library.h"
#include "viewer_log/view/log_view.h"
#include "viewer_log/log/mark_scan.h"
#include "viewer_log/server/open_browser.h"
#include "viewer_log/server/page_document.h"
#include "viewer_log/server/page_request.h"
#include "viewer_log/view/replay_frame.h"
#include "viewer_log/server/replay_request.h"
#include "viewer_log/view/scene_frame.h"
#include "viewer_log/view/signals.h"
#include "viewer_log/server/robot_roots.h"
#include "viewer_log/server/web_server.h"

using namespace twinbus;

namespace {

constexpr std::int64_t kFramePeriod = 16'666'667;  // 60 Hz [ns]
constexpr int kReplayEvery = 12;                   // frames, when nothing moves: 5 Hz
constexpr int kStatusEvery = 6;
constexpr int kStatusRest = 60;            // when nothing moves
constexpr int kShelfEvery = 300;           // frames: 5 s
constexpr std::size_t kMostRequests = 64;  // waiting from pages
constexpr double kLetRun = 0.5;            // the other log runs along unless it is farther off [s]
constexpr double kFillRows = 400.0;        // at most, of what is sent for plots
constexpr double kFillStep = 1.0 / 30.0;   // [s]
constexpr std::int64_t kFillSlice = 8'000'000;  // [ns] of one frame

enum Slot : int { kLive, kStatus, kScene, kSignals, kPath, kReplay, kMarks, kPast, kShelf, kCamera };

struct Arguments {
  std::string log, beside, robot = "hrp1s", runs, recorded_prefix;
  std::string web = beside_program("viewer_log/web/dist", TWINBUS_WEB_FOLDER);
  std::int64_t port = 8050;
  double from = 0.0;
  bool no_open = false;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  Options options("twinbus_log_viewer",
                  "Shows a log in a browser: scrub, step, speed, loop, jump to events; a second "
                  "log as a ghost.\n"
                  "LOG is a file, a run folder, the name of a run, or a link that the page gave; "
                  "none: the newest run.");
  options.positional("LOG", a.log, false, "what to look at");
  options.positional("OTHER", a.beside, false,
                     "a second log, laid over the first at the first STATE of each");
  options.text("--robot", "NAME", a.robot, "name or folder of the robot");
  options.text("--recorded-prefix", "P", a.recorded_prefix, "of the channels in the log");
  options.number("--from", "S", a.from, 0.0, 1e9, "begins so many seconds behind the first event");
  options.text("--runs", "FOLDER", a.runs, "whose run folders the page may open");
  options.integer("--port", "N", a.port, 0, 65535,
                  "first port to try on 127.0.0.1, then the next free; 0: any");
  options.flag("--no-open", a.no_open, "does not open the browser");
  options.text("--web", "FOLDER", a.web, "folder of the page");
  options.parse(argc, argv);
  return a;
}

// A value of a link's fragment, decoded; empty when it is not there.
std::string link_value(const std::string& link, const char* key) {
  std::string fragment = link.substr(link.find('#'));
  fragment.front() = '?';
  std::string path;
  const std::string value = query_value(fragment, key);
  return !value.empty() && decode_target(std::string("/").append(value), path) ? path.substr(1)
                                                                               : std::string();
}

// The seconds before the present moment, for plots: played by readers of its own, a little per frame.
struct Filling {
  std::unique_ptr<LogView> log, other;
  double end = 0.0, step = 0.0;
  std::int64_t jumps = 0;
  std::string rows;
};

class LogViewer {
 public:
  explicit LogViewer(Arguments arguments)
      : arguments_(std::move(arguments)),
        model_(load_robot(arguments_.robot)),
        feed_(model_, arguments_.recorded_prefix),
        shelf_(arguments_.runs) {
    follow_link();
    open(shelf_.add(arguments_.log));
    if (!arguments_.beside.empty()) lay_beside(shelf_.add(arguments_.beside), 0.0);
    if (arguments_.from > 0.0) log_->seek(arguments_.from);
    server_.emplace(web_config());
  }

  void run() {
    announce();
    Ticker ticker(kFramePeriod);
    for (std::int64_t frame = 0; !quit_requested(); ++frame) {
      ticker.wait();
      obey_pages();
      play(1e-9 * static_cast<double>(kFramePeriod));
      follow();
      publish(frame);
      fill();
    }
  }

 private:
  // What the page's own link says of logs is done here; the rest of it goes back to the page.
  void follow_link() {
    const std::size_t mark = arguments_.log.find('#');
    if (mark == std::string::npos) return;
    const std::string link = arguments_.log;
    for (std::size_t begin = mark + 1; begin < link.size();) {
      const std::size_t end = std::min(link.find('&', begin), link.size());
      const std::string part = link.substr(begin, end - begin);
      if (!part.empty() && !part.starts_with("token=")) fragment_.append("&").append(part);
      begin = end + 1;
    }
    arguments_.log = link_value(link, "log");
    if (arguments_.log.empty())
      throw std::runtime_error("the link names no log: it needs #log=NAME");
    if (arguments_.beside.empty()) arguments_.beside = link_value(link, "with");
  }

  WebConfig web_config() {
    WebConfig config;
    config.port = static_cast<int>(arguments_.port);
    if (const char* token = std::getenv("TWINBUS_VIEWER_TOKEN")) {
      if (std::strlen(token) < 16)
        throw std::runtime_error("TWINBUS_VIEWER_TOKEN: at least 16 characters are needed");
      config.token = token;
    }
    config.documents.push_back(page_document(arguments_.web));
    config.roots = robot_roots(model_);
    config.roots.push_back({"/", arguments_.web});
    config.documents.push_back({"/robot.urdf", "application/xml", model_.urdf_text});
    config.on_message = [this](const std::string& text, bool trusted) -> std::string {
      ReplayRequest request;
      std::string problem;
      if (!read_replay_request(text, trusted, request, problem)) return note_frame(problem);
      if (request.what == ReplayRequest::What::kHello) return hello_frame(model_, trusted);
      const std::lock_guard<std::mutex> lock(mutex_);
      // Of a scrubbing page only the newest place is of interest.
      if (request.what == ReplayRequest::What::kSeek && !inbox_.empty() &&
          inbox_.back().what == request.what)
        inbox_.pop_back();
      if (inbox_.size() < kMostRequests) inbox_.push_back(request);
      return {};
    };
    return config;
  }

  void announce() {
    const std::string address = server_->address() + fragment_;
    std::printf("twinbus_log_viewer: %s, %.1f s; ready at %s\n", log_->file().c_str(),
                log_->duration(), address.c_str());
    std::fflush(stdout);
    if (!arguments_.no_open) open_browser(address);
  }

  // Throws like LogView, and then all stays as it was.
  void open(const std::string& name) {
    const ShelvedLog* log = shelf_.find(name);
    if (log == nullptr) throw std::runtime_error("no log '" + name + "' is listed");
    auto opened = std::make_unique<LogView>(model_, log->file, feed_);
    log_ = std::move(opened);
    filling_.reset();
    state_.name = name;
    state_.in = state_.out = -1.0;
    state_.playing = false;
    ++opened_;
    scan_.reset();
    scan_ = std::make_unique<MarkScan>(
        log->file,
        [this](const LogEvent& event, MarkFinder& finder) { feed_.find_marks(event, finder); });
  }

  void lay_beside(const std::string& name, double shift) {
    state_.shift = shift;
    if (name != state_.beside || !other_) {
      const ShelvedLog* log = shelf_.find(name);
      if (!name.empty() && log == nullptr)
        throw std::runtime_error("no log '" + name + "' is listed");
      auto opened = name.empty() ? nullptr : std::make_unique<LogView>(model_, log->file, feed_);
      other_ = std::move(opened);
      state_.beside = name;
    }
    filling_.reset();
    changed_ = true;
  }

  void obey_pages() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      asked_.swap(inbox_);
    }
    for (const ReplayRequest& request : asked_) {
      try {
        obey(request);
        changed_ = true;
      } catch (const std::exception& error) {
        std::fprintf(stderr, "twinbus_log_viewer: %s\n", error.what());
        trouble_ = error.what();
      }
    }
    asked_.clear();
  }

  void obey(const ReplayRequest& request) {
    switch (request.what) {
      case ReplayRequest::What::kPlay:
        if (log_->position() >= end() - 1e-3) log_->seek(begin());
        state_.playing = true;
        break;
      case ReplayRequest::What::kPause:
        state_.playing = false;
        break;
      case ReplayRequest::What::kSeek:
        log_->seek(request.seconds);
        break;
      case ReplayRequest::What::kStep:
        state_.playing = false;
        log_->step(request.by);
        break;
      case ReplayRequest::What::kSpeed:
        state_.speed = request.speed;
        break;
      case ReplayRequest::What::kLoop:
        state_.loop = request.on;
        break;
      case ReplayRequest::What::kMark:
        state_.in = request.in;
        state_.out = request.out;
        break;
      case ReplayRequest::What::kOpen:
        open(request.log);
        break;
      case ReplayRequest::What::kBeside:
        lay_beside(request.log, request.seconds);
        break;
      case ReplayRequest::What::kFill:
        start_fill(request.seconds);
        break;
      default:
        break;
    }
  }

  double begin() const { return state_.in >= 0.0 ? state_.in : log_->first_state(); }
  double end() const {
    return state_.out >= 0.0 ? std::min(state_.out, log_->duration()) : log_->duration();
  }

  void play(double dt) {
    if (!state_.playing) return;
    log_->advance(dt * state_.speed);
    changed_ = true;
    if (log_->position() < end() && !log_->at_end()) return;
    if (state_.loop) {
      log_->seek(begin());
    } else {
      state_.playing = false;
    }
  }

  // Both at their first STATE at the same moment, but for the shift.
  double moment_of(const LogView& other, double seconds) const {
    return seconds - log_->first_state() + other.first_state() + state_.shift;
  }

  // Brings a log to a moment; false when it has nothing there.
  static bool bring(LogView& log, double moment) {
    if (moment < log.first_state() || moment > log.duration()) return false;
    const double ahead = moment - log.position();
    if (ahead < 0.0 || ahead > kLetRun) {
      log.seek(moment);
    } else if (ahead > 0.0) {
      log.advance(ahead);
    }
    return true;
  }

  void follow() {
    if (!other_ || !changed_) return;
    state_.beside_shown = bring(*other_, moment_of(*other_, log_->position()));
  }

  Recorded recorded(const LogView& log, const LogView* other) const {
    Recorded shown{.seconds = log.position(), .place = log.place()};
    if (other != nullptr) {
      shown.other = &other->view();
      shown.other_now_ns = other->now_ns();
      shown.other_place = other->place();
    }
    return shown;
  }

  void publish(std::int64_t frame) {
    state_.scanned = scan_->progress();
    if (changed_ || frame % kReplayEvery == 0)
      server_->publish(kReplay, replay_frame(state_, *log_));
    if (frame % kShelfEvery == 0 || !trouble_.empty()) {
      shelf_.look();
      server_->publish(kShelf, shelf_frame(shelf_, trouble_));
      trouble_.clear();
    }
    if (scan_->take_news(marks_, left_out_))
      server_->publish(kMarks, marks_frame(marks_, left_out_));
    if (changed_ || frame == 0) {
      const StackView& view = log_->view();
      const std::int64_t now = log_->now_ns();
      const Recorded with = recorded(*log_, state_.beside_shown ? other_.get() : nullptr);
      server_->publish(kLive, live_frame(view, now, &with));
      server_->publish(kSignals, signals_frame(view, now, &with));
      const auto scene = std::pair(opened_ * 1000000 + log_->jumps(), view.scene_version());
      if (scene != shown_scene_) {
        shown_scene_ = scene;
        server_->publish(kScene, scene_frame(view, log_->place()));
      }
      if (view.camera().version() != shown_camera_ && view.camera().version() > 0)
        server_->publish(kCamera, view.camera().frame());
      shown_camera_ = view.camera().version();
      if (view.arm_path().version() != shown_path_ && view.arm_path().version() > 0)
        server_->publish(kPath, path_frame(view));
      shown_path_ = view.arm_path().version();
    }
    if (frame % kStatusEvery == 0 &&
        (state_.playing || changed_ || frame % kStatusRest == 0 || status_due_)) {
      server_->publish(kStatus, status_frame(log_->view(), log_->now_ns()));
      status_due_ = false;
    }
    status_due_ = status_due_ || changed_;
    changed_ = false;
  }

  void start_fill(double seconds) {
    filling_.emplace();
    filling_->end = log_->position();
    filling_->jumps = log_->jumps();
    filling_->step = std::max(kFillStep, seconds / kFillRows);
    filling_->log = std::make_unique<LogView>(model_, log_->file(), feed_);
    filling_->log->seek(std::max(log_->first_state(), filling_->end - seconds));
    if (other_) filling_->other = std::make_unique<LogView>(model_, other_->file(), feed_);
  }

  void fill() {
    if (!filling_) return;
    Filling& f = *filling_;
    const std::int64_t start = monotonic_ns();
    while (monotonic_ns() - start < kFillSlice) {
      const bool last = f.log->position() >= f.end - 1e-6;
      const bool shown = f.other && bring(*f.other, moment_of(*f.other, f.log->position()));
      const Recorded with = recorded(*f.log, shown ? f.other.get() : nullptr);
      if (!f.rows.empty()) f.rows += ',';
      f.rows += '[';
      f.rows += signals_frame(f.log->view(), f.log->now_ns(), &with);
      f.rows += ',';
      f.rows += live_frame(f.log->view(), f.log->now_ns(), &with);
      f.rows += ']';
      if (last) {
        std::string past = "{\"type\":\"past\",\"jumps\":";
        past += std::to_string(f.jumps);
        past += ",\"rows\":[";
        past += f.rows;
        past += "]}";
        server_->publish(kPast, std::move(past));
        filling_.reset();
        return;
      }
      f.log->advance(std::min(f.step, f.end - f.log->position()));
    }
  }

  Arguments arguments_;
  const Model model_;
  MessageFeed feed_;
  LogShelf shelf_;
  std::string fragment_, trouble_;
  ReplayState state_;
  std::unique_ptr<LogView> log_, other_;
  std::unique_ptr<MarkScan> scan_;
  std::optional<Filling> filling_;
  std::vector<LogMark> marks_;
  std::int64_t left_out_ = 0, opened_ = 0, shown_path_ = 0, shown_camera_ = 0;
  std::pair<std::int64_t, std::int64_t> shown_scene_{-1, -1};
  bool changed_ = true, status_due_ = true;
  std::mutex mutex_;  // guards inbox_
  std::vector<ReplayRequest> inbox_, asked_;
  std::optional<WebServer> server_;  // last: its thread uses the members above
};

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments = parse(argc, argv);
  catch_quit_signals();
  give_way();
  LogViewer viewer(std::move(arguments));
  viewer.run();
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "twinbus_log_viewer: %s\n", error.what());
  return 1;
}
