#include "bridge/source/refusal_teller.h"

#include <cstdio>

#include "common/math/index.h"

namespace twinbus::inline bridge {

namespace {
constexpr std::int64_t kAgain_ns = 10'000'000'000;
}  // namespace

std::array<char, 200> refusal_sentence(const RefusedCommand& refused, const Model& model) noexcept {
  std::array<char, 200> text{};
  const auto given = static_cast<long long>(refused.given), wanted = static_cast<long long>(refused.wanted);
  const char* form = nullptr;
  switch (refused.verdict) {
    case GateVerdict::kOtherRun:
      form = "its run_id is %lld, the active source's %lld: copy run_id from the newest STATE";
      break;
    case GateVerdict::kOtherTerm:
      form = "its term is %lld, the active source's %lld: copy term from the newest STATE";
      break;
    case GateVerdict::kOtherController:
      form = "controller %lld speaks, and %lld is obeyed: end that one first, or change over with CONTROLLER_REQUEST";
      break;
    case GateVerdict::kOldTick:
      form = "its tick is %lld, and %lld was obeyed already: copy tick from the newest STATE";
      break;
    case GateVerdict::kTooOld:
      form = "its tick is %lld, the source is at %lld: copy tick from the newest STATE and answer within the command timeout";
      break;
    case GateVerdict::kWrongSize:
      form = "its joint_count is %lld, this robot's %lld: copy joint_count from STATE";
      break;
    case GateVerdict::kWrongModel:
      form = "its model_hash is %lld, this robot's %lld: copy model_hash from STATE; another robot or older files otherwise";
      break;
    case GateVerdict::kNotFinite:
      std::snprintf(text.data(), text.size(), "a number of joint %.60s is not finite: look for NaN in q, qd, tau, kp, kd",
                    refused.joint >= 0 && refused.joint < model.bus_count() ? model.joints[at(model.bus_joints[at(refused.joint)])].name.c_str() : "?");
      return text;
    case GateVerdict::kAccepted:
    case GateVerdict::kClosed:
    case GateVerdict::kStopped:
    case GateVerdict::kPlanRuns:
      return text;
  }
  std::snprintf(text.data(), text.size(), form, given, wanted);
  return text;
}

bool RefusalTeller::next(const RefusedCommand& refused, const Model& model, std::int64_t now_ns, Event& event) noexcept {
  if (refused.in_a_row < kInARow || (refused.verdict == told_ && now_ns - told_ns_ < kAgain_ns)) return false;
  const std::array<char, 200> why = refusal_sentence(refused, model);
  if (why[0] == '\0') return false;
  told_ = refused.verdict;
  told_ns_ = now_ns;
  event.severity = 1;
  event.text.fill('\0');
  std::snprintf(event.text.data(), event.text.size(), "COMMAND is refused, %lld in a row: %.160s", static_cast<long long>(refused.in_a_row), why.data());
  return true;
}

}  // namespace twinbus::bridge
