// A Model from the tree of a URDF: links joined by fixed joints become one, parents come before
// children, and the bus keeps the order of the file.

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"
#include "robot/description/urdf.h"

namespace twinbus::inline robot {

class ModelBuilder {
 public:
  // file: for messages.
  ModelBuilder(UrdfTree tree, std::string file) : tree_(std::move(tree)), file_(std::move(file)) {}

  // Joints that robot.yaml fixes at 0.  Throws std::runtime_error if there is no such joint.
  void fix_joints(const std::vector<std::string>& names, const std::string& yaml_file);

  // Joints without a motor rest at an angle: they follow the nearest joint before them that has one, by 0 times its own.
  // Throws as fix_joints does, or if one is fixed, follows another or has no such joint before it.
  void rest_joints(const std::vector<std::string>& names, double angle, const std::string& where);

  // Fixes the joints behind which nothing has mass; returns their names.
  std::vector<std::string> fix_weightless();

  // Fills joints, links, frames, bus order and mimic joints.  Throws std::runtime_error, with the
  // remedy, when a joint moves nothing that has mass, or there are too many joints for the bus
  // (unless for_bus is false).
  void build(Model& model, bool for_bus = true);

 private:
  int urdf_joint(const std::string& name, const std::string& where) const;
  void grow(Model& model, int urdf_link, int body, const Eigen::Isometry3d& in_body);
  void finish_masses(Model& model) const;
  void resolve_mimic(Model& model, std::size_t urdf_index) const;

  UrdfTree tree_;
  std::string file_;
  std::vector<Frame> frames_;     // per URDF link
  std::vector<int> model_index_;  // per URDF joint, -1 if fixed
};

}  // namespace twinbus::robot
