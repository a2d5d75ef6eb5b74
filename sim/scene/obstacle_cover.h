// Boxes for obstacles of any shape: surfaces of triangles, points that a sensor saw, height maps.
//
// Space is cut into cells along the axes of the shape.  A cell that the shape touches (separating axes of a triangle and
// a box: Akenine-Moeller 2001), or that it shuts in, is solid; solid cells are put together to boxes, greedily.  So
// everything of the shape is in a box, and nothing is farther from the shape than a cell's diagonal.  World, guard and
// planner all take these boxes: what they call clear is clear of the shape itself.

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "robot/collision/collision.h"
#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline sim {

// Heights above z = 0 of points `spacing` apart, rows along x; between them the surface is bilinear, below it all is
// solid.
struct HeightMap {
  int rows = 0, columns = 0;
  double spacing = 0.1;         // [m]
  std::vector<double> heights;  // row by row, at least 0 [m]
};

// In the frame of the shape; cell: longest edge of a cell [m].  Throw std::runtime_error when the cells are too many.
std::vector<Obstacle> cover_mesh(const TriangleMesh& mesh, double cell);
std::vector<Obstacle> cover_points(const std::vector<Eigen::Vector3d>& points, double cell);
std::vector<Obstacle> cover_heights(const HeightMap& map, double cell);

// Text of numbers, three a line: x y z [m].  What follows on a line (colours) and lines after '#' are left out.  Throws
// std::runtime_error naming file and line.
std::vector<Eigen::Vector3d> parse_points(const std::string& text, const std::string& file);
// A row of heights a line, all of one length, at least 2 x 2.  Throws likewise.
HeightMap parse_heights(const std::string& text, const std::string& file, double spacing);

}  // namespace twinbus::sim
