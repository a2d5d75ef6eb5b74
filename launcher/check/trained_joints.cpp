#include "launcher/check/trained_joints.h"

#include "common/text/strict_yaml.h"

namespace twinbus::inline launcher {

std::vector<TrainedJoint> read_trained_joints(const std::string& spec_file, const Model& model) {
  const ConfigNode spec = ConfigNode::load(spec_file);
  if (!spec.has("spec")) spec.fail("spec", "is missing: this is no SPEC.yaml; ./twinbus policy MODEL --propose FILE writes one");
  std::vector<TrainedJoint> trained;
  bool says = false;
  for (const ConfigNode& joint : spec.list("joints")) {
    TrainedJoint one{.joint = joint.text("name"),
                     .rotor_inertia = joint.number("armature", 0.0, 1e3, 0.0),
                     .friction = joint.number("friction", 0.0, 1e4, 0.0)};
    if (model.find_joint(one.joint) < 0) joint.fail("name", "is " + one.joint + ", which the robot has not");
    says = says || one.rotor_inertia > 0.0 || one.friction > 0.0;
    trained.push_back(std::move(one));
  }
  if (!says) spec.fail("joints", "say neither armature nor friction of any joint: nothing is to be taken over");
  return trained;
}

}  // namespace twinbus::launcher
