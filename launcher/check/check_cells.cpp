#include "launcher/check/check_cells.h"

#include <unistd.h>

#include <cstdio>

#include "common/file/disk_cache.h"
#include "robot/collision/exact/posture_cells_cache.h"
#include "common/process/process.h"

namespace twinbus::inline launcher {

int check_cells(const Model& model) {
  const RobotGeometry geometry = build_geometry(model);
  SelfCollision check(model, geometry);
  const auto pairs = static_cast<int>(check.pairs().size());
  const std::int64_t begin = monotonic_ns();
  if (use_kept_cells(model, geometry, check)) {
    std::printf("%s: cells of %d pairs are kept in %s, read and checked in %.0f ms\n",
                model.name.c_str(), pairs, disk_cache().folder().c_str(),
                1e3 * seconds_since(begin));
    return 0;
  }
  const bool terminal = isatty(STDERR_FILENO) != 0;
  find_and_keep_cells(model, geometry, check, [&](int done) {
    if (terminal) std::fprintf(stderr, "\r%d of %d pairs", done, pairs);
  });
  if (terminal) std::fprintf(stderr, "\r                              \r");
  const bool kept = !disk_cache().folder().empty();
  std::printf("%s: cells of %d pairs found in %.1f s, %s\n", model.name.c_str(), pairs,
              seconds_since(begin),
              kept ? ("kept in " + disk_cache().folder()).c_str()
                   : "not kept: there is no cache folder (TWINBUS_CACHE)");
  return kept ? 0 : 1;
}

}  // namespace twinbus::launcher
