// Sentences of EVENT for a console: the same one again within a while is counted, not said.
//
// Numbers in a sentence do not make it another one.

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace twinbus::inline launcher {

// With # for every number, so that sentences which differ by numbers alone are the same.
std::string without_numbers(const std::string& text);

class EventGroups {
 public:
  // The lines to print now: new sentences at once, and "SENTENCE (12 times more in a minute)" of those that came again.
  std::vector<std::string> take(const std::vector<std::string>& events, std::int64_t now_ns);

 private:
  struct Group {
    std::int64_t since_ns = 0;
    int more = 0;      // that were not said
    std::string last;  // of them
  };
  std::map<std::string, Group> groups_;
};

}  // namespace twinbus::launcher
