// Which rung of a ladder is chosen.

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "launcher/run/ladder.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kMargin = 1.3;        // of the error asked for
constexpr double kSure = 0.97;         // of it may be used up where two methods say how well the yardstick is known
constexpr double kAgreement = 2.0;     // of it the finest two runs agree to so small a part
constexpr double kSecond = 3.0;        // times it order 2 may be off where they do

}  // namespace

double Ladder::estimate(std::size_t rung) const {
  return rung + 1 == rungs.size() ? agreement : rungs[rung].apart;
}

namespace {

// Which differ by how fine they are alone.
bool same_method(const Rung& a, const Rung& b) {
  return a.order == b.order && a.less == b.less && (a.local > 0.0) == (b.local > 0.0);
}

bool no_coarser(const Rung& a, const Rung& b) { return a.step <= b.step && a.local <= b.local; }

// The run of order 2 with the finest step that models everything; null: there is none.
const Rung* finest_second(const std::vector<Rung>& rungs) {
  const Rung* finest = nullptr;
  for (const Rung& rung : rungs) {
    const bool asked = rung.order == 2 && rung.less.none() && !(rung.local > 0.0);
    if (asked && (finest == nullptr || rung.step < finest->step)) finest = &rung;
  }
  return finest;
}
}  // namespace

bool Ladder::proven(double error) const {
  if (!parted.empty() || !(agreement <= error / kAgreement)) return false;
  const Rung* second = finest_second(rungs);
  return second == nullptr || second->apart <= kSecond * error;
}

std::string Ladder::why_none_holds(double error) const {
  const Rung* off = nullptr;
  std::string why;
  if (const Rung* second = finest_second(rungs); agreement <= error / kAgreement && second != nullptr && !proven(error)) {
    off = second;
    why = formatted(
        "no order and step holds %.3g mm: order 2 at %.3g ms is off by %.3g mm while the finest two runs agree to %.3g mm",
        1e3 * error, 1e3 * off->step, 1e3 * off->apart, 1e3 * agreement);
  } else {
    const auto other = std::find_if(rungs.begin(), rungs.end(), [&](const Rung& rung) { return rung.apart == agreement; });
    if (other != rungs.end()) off = &*other;
    why = formatted("no order and step holds %.3g mm: the finest two runs differ by %.3g mm", 1e3 * error, 1e3 * agreement);
  }
  if (off != nullptr && !off->body.empty()) why += ", " + off->body + formatted(" at %.2f s", off->at);
  return why;
}

double Ladder::allowed(double error) const {
  const Rung* second = finest_second(rungs);
  const double known = second == nullptr ? kUnbounded : agreement + second->apart;
  return std::max(error / kMargin, kSure * error - known);
}

bool Ladder::holds(const Rung& rung, double error) const {
  const double most = allowed(error);
  int as_fine = 0;
  const bool all = std::all_of(rungs.begin(), rungs.end(), [&](const Rung& finer) {
    if (!same_method(finer, rung) || !no_coarser(finer, rung)) return true;
    ++as_fine;
    return finer.whole && finer.apart <= most;
  });
  return all && (as_fine > 1 || !(rung.local > 0.0) || !rung.less.none());
}

int Ladder::choose(double error) const {
  if (!proven(error)) return -1;
  int best = -1;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    if (!rungs[i].less.none() || !holds(rungs[i], error)) continue;
    if (best < 0 || rungs[i].work < rungs[at(best)].work) best = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < rungs.size() && best >= 0; ++i) {
    if (!rungs[i].less.none() && holds(rungs[i], error) && rungs[i].cost < rungs[at(best)].cost) best = static_cast<int>(i);
  }
  return best;
}

int Ladder::choose_within(double budget) const {
  int best = -1;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    if (!rungs[i].whole || !(rungs[i].cost <= budget)) continue;
    if (best < 0 || estimate(i) < estimate(at(best))) best = static_cast<int>(i);
  }
  return best;
}

}  // namespace twinbus::launcher
