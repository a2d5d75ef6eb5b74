// Whatever a file of the cache says of the bounds of a mesh: it is refused with a sentence, or it holds the mesh.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "common/file/disk_cache.h"
#include "robot/collision/links/geometry_cache.h"
#include "geometry/bounds/triangle_clusters.h"

using namespace twinbus;

namespace {

const LinkGeometry& a_link() {
  static const LinkGeometry link = [] {
    Shape box, other;
    box.size = {0.1, 0.2, 0.3};
    other.size = {0.2, 0.1, 0.1};
    other.pose.translation() = Eigen::Vector3d(0.0, 0.1, 0.1);
    return link_geometry({box, other});
  }();
  return link;
}

const std::string& its_bounds() {
  static const std::string bytes = [] {
    std::vector<int> order;
    (void)triangle_clusters(a_link().mesh, order);
    return packed_bounds(a_link(), order);
  }();
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::string why;
  (void)DiskCache::unsealed(bytes, "bounds", {}, why);
  // As it comes, and as damage of good bounds: where (two bytes), then what instead.
  std::string damaged = its_bounds();
  for (std::size_t i = 0; i + 3 <= size; i += 3)
    damaged[(data[i] * 256U + data[i + 1]) % damaged.size()] = static_cast<char>(data[i + 2]);
  for (const std::string& content : {bytes, damaged}) {
    LinkGeometry link = a_link();
    if (unpack_bounds(content, link, why)) {
      verify(link);  // throws, which ends the fuzzer
    } else if (why.empty()) {
      std::abort();
    }
  }
  return 0;
}
