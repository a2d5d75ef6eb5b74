// One process of a running stack started anew by hand: ./twinbus restart NAME.
//
// The stack belongs to the `up` that started it, so the wish is a file in its run folder, and so is the answer.

#pragma once

#include <cstdint>
#include <string>

#include "launcher/stack/supervisor.h"

namespace twinbus::inline launcher {

class RestartRequests {
 public:
  // Says in the folder which process looks after it.
  explicit RestartRequests(const std::string& folder);
  ~RestartRequests();
  RestartRequests(const RestartRequests&) = delete;
  RestartRequests& operator=(const RestartRequests&) = delete;

  // Obeys a wish that has come since the last call; cheap enough for every turn of a loop.
  void look(Supervisor& supervisor, std::int64_t now_ns);

 private:
  std::string folder_;
  std::int64_t looked_ns_ = 0;
};

// A viewer that is started again has the addresses it had.
void keep_viewer_addresses();

}  // namespace twinbus::launcher
