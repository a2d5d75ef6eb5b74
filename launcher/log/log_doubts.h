// Which physics steps of the simulated worlds of a log are not to be trusted, as TRUTH says.

#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline launcher {

class LogDoubts {
 public:
  // A message of TRUTH, with or without a prefix; anything else says nothing.  Sentences of what is new in it: a kind of doubt that its world did not have before.
  std::vector<std::string> add(std::string_view channel, std::span<const std::uint8_t> data);
  bool heard() const { return !newest_.empty(); }  // a TRUTH
  // A line for each world that has some.
  std::string text() const;

 private:
  static constexpr std::size_t kMostWorlds = 64;

  std::map<std::int64_t, SimTruth> newest_;  // by run, of the first kMostWorlds
};

}  // namespace twinbus::launcher
