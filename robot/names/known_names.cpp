#include "robot/names/known_names.h"

#include <algorithm>
#include <map>

#include "common/text/closest_name.h"

namespace twinbus::inline robot {

namespace {

KnownElement leaf(const char* name, std::vector<const char*> attributes) {
  return {.name = name, .attributes = std::move(attributes), .children = {}};
}

// Content of another program, whatever it is.
KnownElement foreign(const char* name) {
  return {.name = name, .attributes = {}, .children = {}, .open = true};
}

KnownElement once(KnownElement element) {
  element.once = true;
  return element;
}

KnownElement origin() { return once(leaf("origin", {"xyz", "rpy"})); }

KnownElement urdf_material() {
  return {.name = "material",
          .attributes = {"name"},
          .children = {leaf("color", {"rgba"}), leaf("texture", {"filename"})}};
}

KnownElement urdf_shape(const char* name) {
  const KnownElement geometry = {
      .name = "geometry",
      .attributes = {},
      .children = {leaf("box", {"size"}), leaf("cylinder", {"radius", "length"}),
                   leaf("sphere", {"radius"}), leaf("capsule", {"radius", "length"}),
                   leaf("mesh", {"filename", "scale"})}};
  return {
      .name = name,
      .attributes = {"name", "group"},
      .children = {origin(), once(geometry), urdf_material(), foreign("verbose"),
                   foreign("contact_coefficients"), foreign("surface"), foreign("safety_margin")}};
}

KnownElement make_urdf() {
  const KnownElement link = {
      .name = "link",
      .attributes = {"name", "type"},
      .children = {
          once({.name = "inertial",
                .attributes = {},
                .children = {origin(), once(leaf("mass", {"value"})),
                             once(leaf("inertia", {"ixx", "ixy", "ixz", "iyy", "iyz", "izz", "iyx", "izx", "izy"}))}}),
          urdf_shape("visual"), urdf_shape("collision"), foreign("contact"),
          foreign("self_collision_checking"), foreign("sensor"), foreign("gravity"),
          foreign("gazebo")}};
  const KnownElement joint = {
      .name = "joint",
      .attributes = {"name", "type"},
      .children = {origin(), once(leaf("parent", {"link"})), once(leaf("child", {"link"})),
                   once(leaf("axis", {"xyz"})),
                   once(leaf("limit", {"lower", "upper", "effort", "velocity", "acceleration",
                                       "deceleration", "jerk"})),
                   once(leaf("dynamics", {"damping", "friction", "armature", "rotor_inertia"})),
                   once(leaf("mimic", {"joint", "multiplier", "offset"})),
                   leaf("calibration", {"rising", "falling", "reference_position"}),
                   leaf("safety_controller",
                        {"k_velocity", "k_position", "soft_lower_limit", "soft_upper_limit"}),
                   foreign("limits"), foreign("joint_properties"), foreign("hardwareInterface"),
                   foreign("gazebo")}};
  const KnownElement actuated = {
      .name = "actuator",
      .attributes = {"name", "type"},
      .children = {leaf("mechanicalReduction", {"value"}), leaf("drake:gear_ratio", {"value"}),
                   leaf("drake:rotor_inertia", {"value"}), foreign("hardwareInterface"),
                   foreign("motorTorqueConstant"), foreign("role"), foreign("offset"),
                   foreign("encoderResolution"), foreign("pulsesPerRevolution"), foreign("node"),
                   foreign("api")}};
  KnownElement moved = actuated;
  moved.name = "joint";
  const KnownElement transmission = {
      .name = "transmission",
      .attributes = {"name", "type"},
      .children = {leaf("type", {}), leaf("mechanicalReduction", {"value"}), actuated, moved,
                   foreign("plugin"), foreign("param"), foreign("motorTorqueConstant"),
                   foreign("leftActuator"), foreign("rightActuator"), foreign("flexJoint"),
                   foreign("rollJoint"), foreign("gap_joint"), foreign("compensator"),
                   foreign("use_simulated_gripper_joint"), foreign("simulated_actuated_joint"),
                   foreign("passive_joint")}};
  return {
      .name = "robot",
      .attributes = {"name", "version"},
      .children = {link, joint, urdf_material(), transmission, foreign("gazebo"), foreign("mujoco"),
                   foreign("sensor"), foreign("ros2_control"), foreign("pinocchio"),
                   foreign("isaac"), foreign("isaac_sim"), foreign("webots"), foreign("model"),
                   foreign("controller"), foreign("plugin"), foreign("loop_joint"),
                   foreign("group"), foreign("gripper"), foreign("contact")}};
}

KnownElement make_srdf() {
  KnownElement group = {
      .name = "group",
      .attributes = {"name"},
      .children = {leaf("link", {"name"}), leaf("joint", {"name"}),
                   leaf("chain", {"base_link", "tip_link"}), leaf("passive_joint", {"name"})}};
  group.children.push_back(leaf("group", {"name"}));
  const KnownElement foot = {.name = "left",
                             .attributes = {},
                             .children = {leaf("size", {"height", "width", "depth"}),
                                          leaf("anklePosition", {"x", "y", "z"})}};
  KnownElement other_foot = foot;
  other_foot.name = "right";
  KnownElement specificities = {
      .name = "specificities",
      .attributes = {},
      .children = {{.name = "feet", .attributes = {}, .children = {foot, other_foot}},
                   foreign("hands"),
                   foreign("head"),
                   foreign("chest"),
                   foreign("waist"),
                   foreign("gaze"),
                   foreign("global"),
                   foreign("joints"),
                   foreign("autoCollision")}};
  return {.name = "robot",
          .attributes = {"name", "version"},
          .children = {group,
                       {.name = "group_state",
                        .attributes = {"name", "group"},
                        .children = {leaf("joint", {"name", "value"})}},
                       {.name = "rotor_params",
                        .attributes = {"name"},
                        .children = {leaf("joint", {"name", "mass", "gear_ratio"})}},
                       specificities,
                       leaf("end_effector",
                            {"name", "parent_link", "group", "parent_group", "component_name"}),
                       leaf("virtual_joint", {"name", "type", "parent_frame", "child_link"}),
                       leaf("passive_joint", {"name"}),
                       leaf("disable_collisions", {"link1", "link2", "reason"}),
                       leaf("enable_collisions", {"link1", "link2", "reason"}),
                       leaf("disable_default_collisions", {"link"}),
                       {.name = "link_sphere_approximation",
                        .attributes = {"link"},
                        .children = {leaf("sphere", {"center", "radius"})}},
                       leaf("joint_property", {"joint_name", "property_name", "value"}),
                       foreign("gripper"),
                       foreign("handle"),
                       foreign("contact"),
                       foreign("group_config"),
                       foreign("gazebo"),
                       foreign("drake")}};
}

constexpr std::size_t kMistake = 2;  // letters
constexpr std::size_t kMaxNotes = 20;

class NameCheck {
 public:
  explicit NameCheck(const std::string& file) : file_(file) {}

  void check(const XmlElement& element, const KnownElement& known) {
    std::vector<std::string> names;
    for (const char* name : known.attributes) names.emplace_back(name);
    for (const auto& [name, value] : element.attributes) {
      if (std::find(names.begin(), names.end(), name) != names.end() || is_foreign(name)) continue;
      judge(element.line, "attribute " + quoted(name) + " of <" + element.name + ">", name, names);
    }
    names.clear();
    for (const KnownElement& child : known.children) names.emplace_back(child.name);
    for (const XmlElement& child : element.children) {
      const auto found =
          std::find_if(known.children.begin(), known.children.end(),
                       [&](const KnownElement& each) { return child.name == each.name; });
      if (found != known.children.end()) {
        if (found->once && element.child(child.name) != &child) {
          fail_at(
              file_, child.line,
              "a second <" + child.name + "> in <" + element.name + "> would be lost; remove one");
        }
        if (!found->open) check(child, *found);
      } else if (!is_foreign(child.name)) {
        judge(child.line, "<" + child.name.substr(0, kShown) + "> in <" + element.name + ">",
              child.name, names);
      }
    }
  }

  void add_notes(std::vector<std::string>& notes) const {
    std::size_t more = 0;
    for (const Ignored& each : ignored_) {
      if (&each - ignored_.data() >= static_cast<std::ptrdiff_t>(kMaxNotes)) {
        ++more;
        continue;
      }
      notes.push_back(file_ + ":" + std::to_string(each.line) + ": " + each.what +
                      " is not known and ignored" +
                      (each.count > 1 ? ", " + std::to_string(each.count) + " times" : ""));
    }
    if (more > 0)
      notes.push_back(file_ + ": " + std::to_string(more) +
                      " other kinds of unknown names are ignored");
  }

 private:
  struct Ignored {
    std::string what;
    int line = 0;
    int count = 0;
  };
  static constexpr std::size_t kShown = 60;

  static std::string quoted(const std::string& name) {
    return "\"" + name.substr(0, kShown) + "\"";
  }

  // drake:gear_ratio, xmlns, xmlns:xacro, xsi:schemaLocation.
  static bool is_foreign(const std::string& name) {
    return name.find(':') != std::string::npos || name == "xmlns";
  }

  void judge(int line, const std::string& what, const std::string& name,
             const std::vector<std::string>& names) {
    const std::string meant = misspelt_name(name, names, kMistake);
    if (!meant.empty()) fail_at(file_, line, what + " is not known; write " + meant);
    const auto [at, first] = index_.emplace(what, ignored_.size());
    if (first) ignored_.push_back({what, line, 0});
    ++ignored_[at->second].count;
  }

  const std::string& file_;
  std::vector<Ignored> ignored_;  // in the order of the file
  std::map<std::string, std::size_t> index_;
};

}  // namespace

const KnownElement& known_urdf() {
  static const KnownElement known = make_urdf();
  return known;
}

const KnownElement& known_srdf() {
  static const KnownElement known = make_srdf();
  return known;
}

void check_names(const XmlElement& root, const KnownElement& known, const std::string& file,
                 std::vector<std::string>& notes) {
  NameCheck names(file);
  names.check(root, known);
  names.add_notes(notes);
}

}  // namespace twinbus::robot
