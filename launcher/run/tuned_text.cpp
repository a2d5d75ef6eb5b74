#include "launcher/run/tuned_text.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "common/text/formatted.h"

namespace twinbus::inline launcher {

namespace {

constexpr char kOfThisRun[] = "# What this run touches";

void write_names(std::ostream& out, const char* key, const std::vector<std::string>& names) {
  if (names.empty()) return;
  out << key << ": [";
  for (std::size_t i = 0; i < names.size(); ++i) out << (i > 0 ? ", " : "") << names[i];
  out << "]\n";
}

// What of an earlier tuning stands in a line of the settings.
void drop_local_error(std::string& line) {
  const std::size_t begin = line.find("solver.local_error:");
  if (begin == std::string::npos) return;
  std::size_t from = begin, end = std::min(line.find_first_of(",}#", begin), line.size());
  if (end < line.size() && line[end] == ',') {
    end = std::min(line.find_first_not_of(' ', end + 1), line.size());
  } else if (const std::size_t comma = line.find_last_not_of(' ', from > 0 ? from - 1 : 0); comma != std::string::npos && line[comma] == ',') {
    from = comma;
  }
  line.erase(from, end - from);
}

bool is_blank(const std::string& line) { return line.find_first_not_of(' ') == std::string::npos; }

}  // namespace

std::string tuned_text(const std::string& scene, const Rung& rung, const std::string& why) {
  std::istringstream in(scene);
  std::ostringstream out;
  out << "# " << why << "\n";
  const std::string order = "solver.order: " + std::to_string(rung.order);
  const std::string local = rung.local > 0.0 ? formatted("solver.local_error: %.9g", rung.local) : "";
  const std::string asked = order + (local.empty() ? "" : ", " + local);
  const std::string lines = order + (local.empty() ? "" : "\n  " + local);  // where the settings are a block of lines
  bool in_settings = false, in_braces = false, has_order = false, dropped = false;
  std::string body;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(kOfThisRun, 0) == 0) continue;
    const bool top = !line.empty() && line[0] != ' ' && line[0] != '#' && line[0] != '-';
    if (top) in_settings = line.rfind("settings:", 0) == 0;
    if (top && in_settings) in_braces = line.find('{') != std::string::npos;
    if (in_settings && !is_blank(line)) {
      drop_local_error(line);
      if (is_blank(line)) continue;
    }
    if (top && line.rfind("step:", 0) == 0) continue;
    if (top) {
      dropped = (line.rfind("held:", 0) == 0 && !rung.less.held.empty()) ||
                (line.rfind("rigid:", 0) == 0 && !rung.less.rigid.empty()) ||
                (line.rfind("self_contact:", 0) == 0 && rung.less.apart) ||
                (line.rfind("aloft:", 0) == 0 && !rung.less.aloft.empty()) ||
                (line.rfind("untouched:", 0) == 0 && !rung.less.untouched.empty()) ||
                (line.rfind("asleep:", 0) == 0 && rung.less.asleep) ||
                (line.rfind("fidelity:", 0) == 0 && !rung.less.none());
    }
    if (dropped) continue;
    const std::size_t at = line.find("solver.order:");
    if (in_settings && at != std::string::npos) {
      const std::size_t end = line.find_first_of(",}#", at);
      line.replace(at, (end == std::string::npos ? line.size() : end) - at, in_braces ? asked : lines);
      has_order = true;
    } else if (top && in_settings && !has_order) {
      if (const std::size_t brace = line.find('{'); brace != std::string::npos) {
        if (scene.find("solver.order:") == std::string::npos) {
          line.insert(brace + 1, asked + ", ");
          has_order = true;
        }
      }
    }
    body += line + "\n";
  }
  out << "step: " << formatted("%.9g", rung.step) << "\n";
  write_names(out, "held", rung.less.held);
  write_names(out, "rigid", rung.less.rigid);
  if (!rung.less.aloft.empty() || !rung.less.untouched.empty())
    out << kOfThisRun << "; not so with another seed, push, length or a fall: leave aloft and untouched out there.\n";
  write_names(out, "aloft", rung.less.aloft);
  write_names(out, "untouched", rung.less.untouched);
  if (rung.less.asleep) out << "asleep: true\n";
  if (!has_order && scene.rfind("settings:", 0) != 0 &&
      scene.find("\nsettings:") == std::string::npos) {
    out << "settings: {" << asked << "}\n";
  } else if (!has_order) {  // a block of lines
    const std::size_t from = body.rfind("settings:", 0) == 0 ? 0 : body.find("\nsettings:") + 1;
    body.insert(body.find('\n', from) + 1, "  " + lines + "\n");
  }
  out << body;
  return out.str();
}

}  // namespace twinbus::launcher
