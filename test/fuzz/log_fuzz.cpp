// Whatever bytes a log file holds: reading, seeking and checking end, and no event reaches beyond them.

#include <cstdlib>
#include <span>

#include "viewer_log/log/log_index.h"
#include "viewer_log/log/log_reader.h"

using namespace twinbus;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  LogReader reader(bytes);
  LogCheck check;
  LogEvent event;
  std::int64_t taken = 0, last = -1;
  while (reader.next(event)) {
    if (event.offset <= last) std::abort();  // or it would never end
    last = event.offset;
    taken += static_cast<std::int64_t>(event.bytes.size());
    check.add(event);
  }
  // Every byte is in an event or counted as damage.
  if (taken + reader.damage().bytes != static_cast<std::int64_t>(size)) std::abort();
  reader.seek(static_cast<std::int64_t>(size) * 1000);
  (void)reader.next(event);
  return 0;
}
