// Boxes that cover obstacles: nothing of the shape is outside of them, and they are no fatter than promised.

#include "sim/scene/obstacle_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

#include "robot/description/load.h"
#include "geometry/mesh_contact/contact_mesh.h"
#include "sim/scene/scene.h"
#include "test/contact_shapes.h"

namespace twinbus {
namespace {

using Eigen::Vector3d;

// How far a point is outside of all boxes [m].
double outside(const std::vector<Obstacle>& boxes, const Vector3d& point) {
  double least = 1e9;
  for (const Obstacle& box : boxes) {
    const Vector3d beyond =
        ((box.pose.inverse() * point).cwiseAbs() - 0.5 * box.size).cwiseMax(0.0);
    least = std::min(least, beyond.norm());
  }
  return least;
}

double volume(const std::vector<Obstacle>& boxes) {
  double sum = 0.0;
  for (const Obstacle& box : boxes) sum += box.size.prod();
  return sum;
}

Vector3d random_point(std::mt19937& random, const Eigen::AlignedBox3d& box) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  return box.min() +
         Vector3d(share(random), share(random), share(random)).cwiseProduct(box.sizes());
}

TEST(ObstacleCover, ABoxOfTrianglesIsThatBox) {
  const TriangleMesh mesh = test::box_triangles({0.3, 0.2, 0.71});
  const std::vector<Obstacle> boxes = cover_mesh(mesh, 0.05);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_LT((boxes[0].size - Vector3d(0.3, 0.2, 0.71)).norm(), 1e-9);
  EXPECT_LT(boxes[0].pose.translation().norm(), 1e-9);
}

TEST(ObstacleCover, ATurnedBoxIsCoveredAndHardlyMore) {
  std::mt19937 random(3);
  TriangleMesh mesh = test::box_triangles({0.4, 0.3, 0.2});
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  for (Vector3d& point : mesh.points) point = turn * point + Vector3d(1.0, -2.0, 0.5);
  const ContactMesh solid(mesh);
  const double cell = 0.02, diagonal = cell * std::sqrt(3.0);
  const std::vector<Obstacle> boxes = cover_mesh(mesh, cell);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d point = random_point(random, solid.box());
    const Vector3d beyond = ((turn.conjugate() * (point - Vector3d(1.0, -2.0, 0.5))).cwiseAbs() -
                             Vector3d(0.2, 0.15, 0.1))
                                .cwiseMax(0.0);
    if (beyond.isZero(0.0)) {
      ++inside;
      ASSERT_LT(outside(boxes, point), 1e-9);
    }
    if (beyond.norm() > diagonal) {
      ASSERT_GT(outside(boxes, point), 0.0);
    }
  }
  EXPECT_GT(inside, 4000);
}

TEST(ObstacleCover, WhatIsOpenStaysOpenAndWhatIsShutInIsSolid) {
  TriangleMesh room = test::box_triangles({1.0, 1.0, 1.0});
  EXPECT_NEAR(volume(cover_mesh(room, 0.1)), 1.0, 1e-9);
  // Without the two triangles of its highest face it is a tub: floor and walls a cell thick.
  std::erase_if(room.triangles, [&](const auto& triangle) {
    return room.points[static_cast<std::size_t>(triangle[0])].z() > 0.0 &&
           room.points[static_cast<std::size_t>(triangle[1])].z() > 0.0 &&
           room.points[static_cast<std::size_t>(triangle[2])].z() > 0.0;
  });
  const std::vector<Obstacle> tub = cover_mesh(room, 0.1);
  EXPECT_NEAR(volume(tub), 1.0 - 0.8 * 0.8 * 0.9, 1e-9);
  EXPECT_GT(outside(tub, Vector3d::Zero()), 0.3);
}

TEST(ObstacleCover, EveryPointOfACloudIsInABoxAndBoxesArePutTogether) {
  std::mt19937 random(5);
  std::vector<Vector3d> points;
  for (int i = 0; i < 40000; ++i) {
    Vector3d point = random_point(random, {Vector3d(0, -1, 0), Vector3d(0, 1, 1)});
    point.x() = 0.7;  // a wall
    points.push_back(point);
  }
  const std::vector<Obstacle> boxes = cover_points(points, 0.05);
  for (const Vector3d& point : points) ASSERT_LT(outside(boxes, point), 1e-9);
  EXPECT_LT(boxes.size(), 5U);
  for (const Obstacle& box : boxes) EXPECT_LE(box.size.x(), 0.05 + 1e-9);
}

TEST(ObstacleCover, TheSurfaceOfAHeightMapIsCoveredAndItsAirIsNot) {
  const HeightMap map =
      parse_heights("0 0.1 0.1\n0.2 0.3 0.1\n0 0 0\n# the end\n", "map.txt", 0.5);
  ASSERT_EQ(map.rows, 3);
  ASSERT_EQ(map.columns, 3);
  const std::vector<Obstacle> boxes = cover_heights(map, 0.05);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double u = 2.0 * share(random), v = 2.0 * share(random);
    const int row = std::min(1, static_cast<int>(u)), column = std::min(1, static_cast<int>(v));
    const double a = u - row, b = v - column;
    const auto at = [&](int r, int c) { return map.heights[static_cast<std::size_t>(3 * r + c)]; };
    const double height = (1 - a) * ((1 - b) * at(row, column) + b * at(row, column + 1)) +
                          a * ((1 - b) * at(row + 1, column) + b * at(row + 1, column + 1));
    ASSERT_LT(outside(boxes, {0.5 * u, 0.5 * v, height * share(random)}), 1e-9) << u << ' ' << v;
    const double highest = std::max({at(row, column), at(row, column + 1), at(row + 1, column),
                                     at(row + 1, column + 1)});
    if (a > 0.11 && a < 0.89 && b > 0.11 && b < 0.89) {
      ASSERT_GT(outside(boxes, {0.5 * u, 0.5 * v, highest + 0.051}), 0.0) << u << ' ' << v;
    }
  }
}

std::string complaint(const std::string& file, const std::string& content,
                      const std::string& obstacle) {
  std::ofstream(testing::TempDir() + file) << content;
  const std::string scene = testing::TempDir() + "obstacle_cover_scene.yaml";
  std::ofstream(scene) << "obstacles:\n  - {file: " << file << ", position: [1, 0, 0], "
                       << obstacle << "}\n";
  try {
    return std::to_string(load_scene(scene).obstacles.size()) + " boxes";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(ObstacleCover, SceneFilesHaveThemAndSaySoWhenTheyCannot) {
  EXPECT_EQ(complaint("cloud.xyz", "0 0 0 255 0 0\n0.01 0 0\n", "shape: points"), "1 boxes");
  EXPECT_EQ(complaint("map.txt", "0.1 0.1\n0.1 0.1\n", "shape: height_map, spacing: 0.2"),
            "1 boxes");
  const auto refused = [](const char* file, const std::string& content, const char* obstacle, const char* part) {
    const std::string said = complaint(file, content, obstacle);
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  refused("cloud.xyz", "0 0 0\n1 2\n", "shape: points", "cloud.xyz:2: a point is three numbers");
  refused("cloud.xyz", "0 0 zero\n", "shape: points", "cloud.xyz:1: what is there is no number");
  refused("cloud.xyz", "nan 0 0\n", "shape: points", "no number within");
  refused("cloud.xyz", "# none\n", "shape: points", "no point is in it");
  refused("cloud.xyz", "0 0 0\n900 900 900\n", "shape: points", "take a larger `cell`");
  refused("map.txt", "0 0 0\n0 0\n", "shape: height_map, spacing: 0.1", "map.txt:2: this row has 2 heights, the first 3");
  refused("map.txt", "0 -1\n0 0\n", "shape: height_map, spacing: 0.1", "map.txt:1: a height is below 0");
  std::string scattered;
  for (int i = 0; i < 300; ++i) scattered += std::to_string(0.1 * i) + " 0 " + std::to_string(0.1 * (i % 7)) + "\n";
  refused("cloud.xyz", scattered, "shape: points, cell: 0.02", "at most 200, and these are");
}

}  // namespace
}  // namespace twinbus
