// The numbers of one link as the kernels of SelfCollision read them.

#pragma once

#include <array>
#include <memory>
#include <vector>

#include "robot/collision/links/link_geometry.h"
#include "robot/collision/exact/self_collision_data.h"

namespace twinbus::inline robot {

constexpr int kCollisionLanes = 8;

inline std::size_t padded_lanes(std::size_t n) {
  return (n + kCollisionLanes - 1) / kCollisionLanes * kCollisionLanes;
}

struct AlignedNumbers {  // that lanes read
  std::vector<float> store;
  float* data = nullptr;
  void resize(std::size_t n, float value = 0.0F) {
    store.assign(n + 16, value);
    void* raw = store.data();
    std::size_t room = store.size() * sizeof(float);
    data = static_cast<float*>(std::align(64, n * sizeof(float), raw, room));
  }
};

void set4(const Eigen::Vector3d& v, double last, float (&to)[4]);

// Owns what the view points to; may be moved.
class CollisionBodyStore {
 public:
  // inner: balls inside, too, which take milliseconds to find.
  CollisionBodyStore(const LinkGeometry& link, bool inner);

  const CollisionBody& view() const noexcept { return view_; }

 private:
  void add_clusters(const LinkGeometry& link);
  void group();
  void add_inner(const LinkGeometry& link);

  CollisionBody view_;
  std::vector<TriangleCluster> clusters_;
  AlignedNumbers center_[3], radius_, block_center_[3], block_radius_, hull_[3];
  AlignedNumbers box_middle_[3], box_half_[3], box_low_[3], box_high_[3], inner_[4];
  std::vector<CollisionTriangleBoxes> triangle_boxes_;
  std::vector<std::array<float, 4>> middle_, half_, witness_;
};

}  // namespace twinbus::robot
