#include "robot/collision/exact/posture_cells_cache.h"

#include <algorithm>
#include <array>
#include <random>

#include "common/file/disk_cache.h"
#include "robot/collision/links/geometry_cache.h"
#include "common/math/index.h"
#include "common/file/byte_pack.h"

namespace twinbus::inline robot {

namespace {

constexpr int kPostures = 200;  // at which they are compared with the triangles

Fingerprint cells_key(const Model& model, const RobotGeometry& geometry,
                      const std::vector<CollisionPair>& pairs) {
  FingerprintMaker maker = fingerprint_of_code();
  const JointCellOptions options;
  maker.add(options.per_joint).add(options.looks);
  for (const Joint& joint : model.joints) {
    maker.add(static_cast<int>(joint.kind)).add(joint.parent).add(joint.lower).add(joint.upper);
    for (int row = 0; row < 3; ++row) {
      maker.add(joint.axis[row]);
      for (int column = 0; column < 4; ++column) maker.add(joint.placement.matrix()(row, column));
    }
    maker.add(joint.mimic).add(joint.mimic_multiplier).add(joint.mimic_offset);
  }
  for (const LinkGeometry& link : geometry.links) {
    const Fingerprint mesh = fingerprint_of(link.mesh).value();
    maker.add(link.link).add(mesh.high).add(mesh.low);
  }
  for (const CollisionPair& pair : pairs) maker.add(pair.link_a).add(pair.link_b);
  return maker.value();
}

// Which pairs touch, at random postures within the limits.
std::vector<std::vector<int>> verdicts(const Model& model, SelfCollision& check) {
  std::mt19937_64 random(1);
  Eigen::VectorXd q(model.joint_count());
  std::vector<std::vector<int>> all;
  for (int i = 0; i < kPostures; ++i) {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      const double low = std::max(joint.lower, -3.0), high = std::min(joint.upper, 3.0);
      q[j] = joint.mimic >= 0 ? joint.mimic_multiplier * q[joint.mimic] + joint.mimic_offset
             : low < high     ? std::uniform_real_distribution<double>(low, high)(random)
                              : 0.0;
    }
    check.place(q);
    const int n = check.touching();
    all.emplace_back(check.hit(), check.hit() + n);
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

}  // namespace

std::string packed_cells(const std::vector<JointCells>& cells) {
  Packer out;
  out.put(static_cast<std::uint64_t>(cells.size()));
  for (const JointCells& c : cells) {
    out.put(c.joints).put(c.joint).put(c.count).put(c.low).put(c.per_unit);
    out.put_all(c.cell).put_all(c.lists);
  }
  return out.bytes();
}

std::optional<std::vector<JointCells>> unpack_cells(const std::string& bytes, const Model& model,
                                                    const RobotGeometry& geometry,
                                                    const std::vector<CollisionPair>& pairs,
                                                    std::string& why) {
  Unpacker in(bytes);
  if (in.get<std::uint64_t>() != pairs.size()) {
    why = "it is of other pairs";
    return std::nullopt;
  }
  std::vector<JointCells> cells;
  for (const CollisionPair& pair : pairs) {
    using Whole = std::array<int, JointCells::kMostJoints>;
    using Real = std::array<double, JointCells::kMostJoints>;
    JointCells c;
    c.joints = in.get<int>();
    std::ranges::copy(in.get<Whole>(), c.joint);
    std::ranges::copy(in.get<Whole>(), c.count);
    std::ranges::copy(in.get<Real>(), c.low);
    std::ranges::copy(in.get<Real>(), c.per_unit);
    c.cell = in.get_all<std::uint32_t>();
    c.lists = in.get_all<std::uint32_t>();
    if (in.broken() || !are_cells_of(c, model, geometry, pair)) {
      why = "its cells are not those of this robot";
      return std::nullopt;
    }
    cells.push_back(std::move(c));
  }
  if (in.whole()) return cells;
  why = "there is something behind its end";
  return std::nullopt;
}

bool use_kept_cells(const Model& model, const RobotGeometry& geometry, SelfCollision& check) {
  if (disk_cache().folder().empty()) return false;
  const Fingerprint key = cells_key(model, geometry, check.pairs());
  const std::optional<std::string> bytes = disk_cache().find("cells", key);
  if (!bytes) return false;
  std::string why;
  std::optional<std::vector<JointCells>> cells =
      unpack_cells(*bytes, model, geometry, check.pairs(), why);
  if (cells) {
    const auto without = verdicts(model, check);
    check.use(std::move(*cells));
    if (verdicts(model, check) == without) return true;
    check.use(std::vector<JointCells>(check.pairs().size()));  // none
    why = "a pair that it says is free touches";
  }
  disk_cache().refuse("cells", key, why);
  return false;
}

void find_and_keep_cells(const Model& model, const RobotGeometry& geometry, SelfCollision& check,
                         const std::function<void(int done)>& progress) {
  std::vector<JointCells> cells = find_joint_cells(model, geometry, check.pairs(), {}, progress);
  if (!disk_cache().folder().empty())
    disk_cache().keep("cells", cells_key(model, geometry, check.pairs()), packed_cells(cells));
  check.use(std::move(cells));
}

}  // namespace twinbus::robot
