#include "viewer_log/view/replay_frame.h"

#include "viewer_log/view/frame_number.h"

namespace twinbus::inline viewer_log {

namespace {
Json time_or_none(double seconds) { return seconds < 0.0 ? Json(nullptr) : number(seconds, 4); }
}  // namespace

std::string replay_frame(const ReplayState& state, const LogView& log) {
  Json frame = {{"type", "replay"},
                {"log", state.name},
                {"position", number(log.position(), 4)},
                {"duration", number(log.duration(), 3)},
                {"first", number(log.first_state(), 4)},
                {"began_us", log.first_utime()},
                {"playing", state.playing},
                {"loop", state.loop},
                {"speed", state.speed},
                {"in", time_or_none(state.in)},
                {"out", time_or_none(state.out)},
                {"jumps", log.jumps()},
                {"scanned", number(state.scanned, 3)},
                {"damage", {{"places", log.damage().places}, {"bytes", log.damage().bytes}}}};
  if (!state.beside.empty()) {
    frame["beside"] = {
        {"log", state.beside}, {"shift", number(state.shift, 4)}, {"shown", state.beside_shown}};
  }
  return dump(frame);
}

std::string marks_frame(const std::vector<LogMark>& marks, std::int64_t left_out) {
  Json list = Json::array();
  for (const LogMark& mark : marks)
    list.push_back({number(mark.seconds, 4), label(mark.kind), mark.text});
  return dump({{"type", "marks"}, {"marks", list}, {"left_out", left_out}});
}

std::string shelf_frame(const LogShelf& shelf, const std::string& trouble) {
  Json list = Json::array();
  for (const ShelvedLog& log : shelf.logs()) {
    list.push_back({{"log", log.name},
                    {"file", log.file},
                    {"bytes", log.bytes},
                    {"changed_s", log.changed_s}});
  }
  return dump({{"type", "shelf"}, {"logs", list}, {"trouble", trouble}});
}

}  // namespace twinbus::viewer_log
