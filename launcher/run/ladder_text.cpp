// What the cache keeps of a ladder.

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "launcher/run/ladder.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kWritten = 1e300;  // stands for it

// Of what is never below zero.
double written(double value) { return std::isfinite(value) ? value : -1.0; }

void write(std::ostream& text, const Moved& moved) {
  text << moved.robots.size() << ' ' << std::min(moved.links, kWritten) << ' ' << moved.lay;
  for (const auto* numbers : {&moved.joints, &moved.robot_ways, &moved.clear, &moved.above}) {
    text << ' ' << numbers->size();
    for (const double number : *numbers) text << ' ' << std::min(number, kWritten);
  }
  text << '\n';
  for (const std::string& robot : moved.robots) text << robot << '\n';
}

bool read(std::istream& in, Moved& moved) {
  std::size_t robots = 0;
  const auto number = [&](double& to) {
    if (!(in >> to)) return false;
    if (to >= kWritten) to = kUnbounded;
    return true;
  };
  if (!(in >> robots) || robots > 1000 || !number(moved.links) || !number(moved.lay)) return false;
  for (auto* numbers : {&moved.joints, &moved.robot_ways, &moved.clear, &moved.above}) {
    std::size_t count = 0;
    if (!(in >> count) || count > 10000) return false;
    numbers->resize(count);
    for (double& each : *numbers) {
      if (!number(each)) return false;
    }
  }
  moved.robots.resize(robots);
  in >> std::ws;
  for (std::string& robot : moved.robots) {
    if (!std::getline(in, robot)) return false;
  }
  return moved.robot_ways.size() == robots;
}

}  // namespace

std::string ladder_text(const Ladder& ladder) {
  std::ostringstream text;
  text.precision(17);
  text << "ladder 12 " << ladder.rungs.size() << ' ' << ladder.parted.size() << ' '
       << written(ladder.agreement) << ' ' << ladder.cost << '\n';
  for (const Rung& r : ladder.rungs) {
    text << r.order << ' ' << r.step << ' ' << r.local << ' ' << r.cost << ' ' << r.work << ' '
         << written(r.apart) << ' ' << r.at << ' ' << r.whole << ' '
         << written(r.bands.off) << ' ' << written(r.bands.gain) << ' ' << written(r.bands.rise) << ' '
         << written(r.bands.depth) << ' ' << r.less.held.size() << ' ' << r.less.rigid.size() << ' ' << r.less.still.size() << ' '
         << r.less.untouched.size() << ' ' << r.less.aloft.size() << ' '
         << r.less.apart << ' ' << r.less.asleep << ' ' << r.body << '\n';
    for (const auto* names : {&r.less.held, &r.less.rigid, &r.less.still, &r.less.untouched, &r.less.aloft}) {
      for (const std::string& name : *names) text << name << '\n';
    }
  }
  for (const Parted& p : ladder.parted)
    text << written(p.apart) << ' ' << p.body << '\n';
  write(text, ladder.moved);
  return text.str();
}

bool read_ladder(const std::string& text, Ladder& ladder) {
  std::istringstream in(text);
  std::string word;
  int version = 0;
  std::size_t rungs = 0, parted = 0;
  Ladder found;
  if (!(in >> word >> version >> rungs >> parted >> found.agreement >> found.cost) ||
      word != "ladder" || version != 12 || rungs > 1000 || parted > 10000) {
    return false;
  }
  const auto endless = [](double value) { return value < 0.0 ? kUnbounded : value; };
  found.agreement = endless(found.agreement);
  for (std::size_t i = 0; i < rungs; ++i) {
    Rung r;
    std::size_t held = 0, rigid = 0, still = 0, untouched = 0, aloft = 0;
    if (!(in >> r.order >> r.step >> r.local >> r.cost >> r.work >> r.apart >> r.at >> r.whole >>
          r.bands.off >> r.bands.gain >> r.bands.rise >> r.bands.depth >>
          held >> rigid >> still >> untouched >> aloft >>
          r.less.apart >> r.less.asleep))
      return false;
    if (r.order < 1 || r.order > 3 || !(r.step > 0.0) || !(r.local >= 0.0)) return false;
    if (std::max({held, rigid, still, untouched, aloft}) > 1000) return false;
    r.apart = endless(r.apart);
    for (double* band : {&r.bands.off, &r.bands.gain, &r.bands.rise, &r.bands.depth}) *band = endless(*band);
    std::getline(in, r.body);
    if (!r.body.empty()) r.body.erase(0, 1);
    r.less.held.resize(held);
    r.less.rigid.resize(rigid);
    r.less.still.resize(still);
    r.less.untouched.resize(untouched);
    r.less.aloft.resize(aloft);
    for (auto* names : {&r.less.held, &r.less.rigid, &r.less.still, &r.less.untouched, &r.less.aloft}) {
      for (std::string& name : *names) {
        if (!std::getline(in, name)) return false;
      }
    }
    found.rungs.push_back(r);
  }
  for (std::size_t i = 0; i < parted; ++i) {
    Parted p;
    if (!(in >> p.apart)) return false;
    p.apart = endless(p.apart);
    std::getline(in, p.body);
    if (!p.body.empty()) p.body.erase(0, 1);
    found.parted.push_back(p);
  }
  if (!read(in, found.moved)) return false;
  ladder = found;
  return true;
}

}  // namespace twinbus::launcher
