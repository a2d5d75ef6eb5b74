#include "launcher/log/log_doubts.h"

#include "common/text/formatted.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/labels.h"
#include "sim/world/step_trust.h"

namespace twinbus::inline launcher {

namespace {

const char* name_of_doubt(std::size_t index) { return label(static_cast<StepDoubt>(index + 1)); }

}  // namespace

std::vector<std::string> LogDoubts::add(std::string_view channel, std::span<const std::uint8_t> data) {
  SimTruth truth;
  if (!channel.ends_with(channel::kTruth) || decode(data, truth) != Status::kOk) return {};
  if (newest_.size() >= kMostWorlds && !newest_.contains(truth.run_id)) return {};
  SimTruth& before = newest_[truth.run_id];
  std::vector<std::string> news;
  for (std::size_t i = 0; i < truth.doubted.size(); ++i) {
    if (truth.doubted[i] == 0 || before.doubted[i] != 0) continue;
    news.push_back(std::string("simulator: doubts a physics step: ") + name_of_doubt(i));
  }
  before = truth;
  return news;
}

std::string LogDoubts::text() const {
  std::string text;
  for (const auto& [run, truth] : newest_) {
    if (truth.doubted_steps == 0) continue;
    text += formatted("not to be trusted: %d physics steps of run %lld since its %.3f s", truth.doubted_steps, static_cast<long long>(run),
                      truth.doubted_since);
    const char* between = " (";
    for (std::size_t i = 0; i < truth.doubted.size(); ++i) {
      if (truth.doubted[i] == 0) continue;
      text += formatted("%s%s %d", between, kDoubtNames[i], truth.doubted[i]);
      between = ", ";
    }
    text += ")\n";
  }
  return text;
}

}  // namespace twinbus::launcher
