// What link_geometry finds around a mesh, kept on disk by the mesh (disk_cache.h).
//
// Nothing that is read is trusted: what can be taken from the mesh itself is (corners of the hull, of
// clusters), and the rest must hold the mesh, or it is found anew.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/file/fingerprint.h"
#include "robot/collision/links/link_geometry.h"

namespace twinbus::inline robot {

// Fills in hull, sphere, capsule and clusters of a link whose mesh and box are there; false,
// with nothing changed, when they are not known or do not hold.
bool recall_bounds(LinkGeometry& link);
// order: the triangles, cluster by cluster.
void keep_bounds(const LinkGeometry& link, const std::vector<int>& order);

// The same of inner_balls(link, balls, points).
bool recall_inner_balls(const LinkGeometry& link, int balls, int points, std::vector<Ball>& found);
void keep_inner_balls(const LinkGeometry& link, int balls, int points,
                      const std::vector<Ball>& found);

// capsule_around(points).
Capsule kept_capsule(const std::vector<Eigen::Vector3d>& points);

// coarse_hull(mesh).
std::optional<TriangleMesh> kept_coarse_hull(const TriangleMesh& mesh);

// Of the mesh, and of the code that finds things about meshes.
FingerprintMaker fingerprint_of(const TriangleMesh& mesh);
FingerprintMaker fingerprint_of_code();

// The bytes that are kept, and back; what does not hold is a sentence in `why` and leaves link as it was.
std::string packed_bounds(const LinkGeometry& link, const std::vector<int>& order);
bool unpack_bounds(const std::string& bytes, LinkGeometry& link, std::string& why);

}  // namespace twinbus::robot
