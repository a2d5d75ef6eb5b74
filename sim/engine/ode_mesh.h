// A set of triangles that ODE collides.

#pragma once

#include <ode/ode.h>

#include <Eigen/Core>
#include <vector>

namespace twinbus::inline sim {

// ODE reads the triangles from here: it must outlive its geoms, and stay where it is.
class OdeMesh {
 public:
  OdeMesh() = default;
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;
  ~OdeMesh() {
    if (data_ != nullptr) dGeomTriMeshDataDestroy(data_);
  }

  void add_point(const Eigen::Vector3d& p) { points_.insert(points_.end(), p.begin(), p.end()); }
  void add_triangle(int a, int b, int c) {
    for (const int corner : {a, b, c}) corners_.push_back(static_cast<dTriIndex>(corner));
  }

  // Null: it has no triangles.
  dGeomID create_geom() {
    if (corners_.empty()) return nullptr;
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, points_.data(), 3 * sizeof(double),
                                static_cast<int>(points_.size() / 3), corners_.data(),
                                static_cast<int>(corners_.size()), 3 * sizeof(dTriIndex));
    return dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }

 private:
  std::vector<double> points_;
  std::vector<dTriIndex> corners_;
  dTriMeshDataID data_ = nullptr;
};

}  // namespace twinbus::sim
