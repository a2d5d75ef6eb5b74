// A source that nobody else is asked about becomes the active one.

#pragma once

#include <cstdint>
#include <stdexcept>

#include "bridge/source/source.h"

namespace twinbus::test {

// Asked tick by tick until it publishes on STATE; now_ns goes on.  Throws std::runtime_error when it does not.
inline void activate(Source& source, std::int64_t run_id, std::int64_t period_ns, std::int64_t& now_ns) {
  SourceRequest request{.run_id = run_id, .target_run_id = run_id, .action = SourceAction::kActivate, .policy = SwitchPolicy::kNow};
  while (!source.publishes_on_state()) {
    if (++request.sequence == 10000) throw std::runtime_error("the source does not become active");
    now_ns += period_ns;
    source.on_source_request(request, now_ns);
    source.begin_tick(now_ns);
    if (!source.publishes_on_state()) source.end_tick(now_ns);
  }
}

}  // namespace twinbus::test
