#include "robot/mjcf/mjcf_model.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "common/math/index.h"
#include "common/text/closest_name.h"
#include "robot/mjcf/mjcf_defaults.h"
#include "robot/mjcf/mjcf_document.h"
#include "robot/mjcf/mjcf_parts.h"
#include "robot/mjcf/mjcf_surface.h"

namespace twinbus::inline robot {

namespace {

constexpr std::size_t kMostOfAKind = 2000;    // bodies, joints, meshes, actuators, excludes, pairs, equalities, keyframes
constexpr int kMostIterations = 10'000;
constexpr std::size_t kMostParts = 20'000;    // geoms and sites

int qpos_size(MjcfJointKind kind) {
  return kind == MjcfJointKind::kFree ? 7 : kind == MjcfJointKind::kBall ? 4 : 1;
}

class Reader {
 public:
  explicit Reader(const MjcfDocument& document) : root_(document.root), defaults_(document.root) {
    model_.folder = document.folder;
    model_.notes = document.notes;
    model_.name = root_.text("model");
    model_.compiler = read_compiler(root_);
  }

  MjcfModel read() {
    refuse_what_no_robot_has();
    each("asset", [&](const MjcfElement& element) {
      if (element.name != "mesh") return;
      limit(element, model_.meshes.size());
      model_.meshes.push_back(read_mjcf_mesh(defaults_.resolved(element, ""), model_.compiler, model_.folder));
    });
    model_.bodies.emplace_back();
    model_.bodies[0].name = "world";
    for (const MjcfElement& section : root_.children) {
      if (section.name == "worldbody") read_parts(section, 0, "", Eigen::Isometry3d::Identity());
    }
    check_twice();
    put_on_ground();
    each("contact", [&](const MjcfElement& element) { read_contact(element); });
    each("equality", [&](const MjcfElement& element) { read_equality(element); });
    each("actuator", [&](const MjcfElement& element) {
      MjcfActuator actuator;
      if (!is_actuator_element(element.name)) return;
      if (!read_mjcf_actuator(defaults_.resolved(element, ""), model_.compiler, actuator, model_.notes)) return;
      (void)need_joint(element, "joint", actuator.joint);
      limit(element, model_.actuators.size());
      model_.actuators.push_back(std::move(actuator));
    });
    each("keyframe", [&](const MjcfElement& element) { read_key(element); });
    each("sensor", [&](const MjcfElement& element) { read_sensor(element); });
    each("tendon", [&](const MjcfElement&) { ++tendons_; });
    if (tendons_ > 0) model_.notes.push_back(std::to_string(tendons_) + " tendons are not modelled: left out");
    read_options();
    return std::move(model_);
  }

 private:
  void each(const std::string& section, const std::function<void(const MjcfElement&)>& visit) const {
    for (const MjcfElement& part : root_.children) {
      if (part.name != section) continue;
      for (const MjcfElement& element : part.children) visit(element);
    }
  }

  // Deformable bodies and what writes bodies by a program of its own.
  void refuse_what_no_robot_has() const {
    each("deformable", [](const MjcfElement& element) {
      if (element.name == "flex") element.fail("a deformable body (flex) is no part of a robot of rigid links; remove it");
    });
    each("asset", [](const MjcfElement& element) {
      if (element.name == "model")
        element.fail("a model attached to a model is not read; save the compiled model with mj_saveLastXML and take that");
    });
  }

  // Recursion is as deep as the tags of all files: 64 each, 100 files, but for <include> inside <body>; bounded by kMostDepth.
  void read_parts(const MjcfElement& owner, int body, const std::string& childclass, const Eigen::Isometry3d& frame,
                  int depth = 0) {
    constexpr int kMostDepth = 400;
    if (depth > kMostDepth) owner.fail("bodies are nested deeper than 400; flatten them");
    for (const MjcfElement& element : owner.children) {
      const std::string& kind = element.name;
      if (kind == "body") {
        read_body(element, body, childclass, frame, depth);
      } else if (kind == "frame") {
        defaults_.check_childclass(element);
        read_parts(element, body, element.text("childclass", childclass), frame * read_place(element, model_.compiler),
                   depth + 1);
      } else if (kind == "joint" || kind == "freejoint") {
        read_joint(element, body, childclass, frame);
      } else if (kind == "geom") {
        count(element);
        model_.bodies[at(body)].geoms.push_back(
            read_mjcf_geom(defaults_.resolved(element, childclass), model_.compiler, frame, model_.meshes));
      } else if (kind == "site") {
        count(element);
        model_.bodies[at(body)].sites.push_back(
            read_mjcf_site(defaults_.resolved(element, childclass), model_.compiler, frame));
      } else if (kind == "inertial") {
        if (model_.bodies[at(body)].has_inertial) element.fail("a second <inertial> of this body; remove one");
        model_.bodies[at(body)].has_inertial = true;
        model_.bodies[at(body)].inertia = read_mjcf_inertial(element, model_.compiler, frame);
      } else if (kind == "composite" || kind == "flexcomp" || kind == "replicate" || kind == "attach") {
        element.fail("is not read: it writes bodies by a program of MuJoCo's; save the compiled model with "
                     "mj_saveLastXML and take that");
      }
    }
  }

  void read_body(const MjcfElement& element, int parent, const std::string& childclass, const Eigen::Isometry3d& frame,
                 int depth) {
    limit(element, model_.bodies.size());
    defaults_.check_childclass(element);
    MjcfBody body;
    body.element.name = element.name;
    body.element.place = element.place;
    body.element.attributes = element.attributes;
    body.name = element.text("name");
    body.parent = parent;
    body.place = frame * read_place(element, model_.compiler);
    body.mocap = element.flag("mocap", false);
    body.gravcomp = element.number("gravcomp", 0.0, -1e3, 1e3);
    model_.bodies.push_back(std::move(body));
    const int index = static_cast<int>(model_.bodies.size()) - 1;
    read_parts(element, index, element.text("childclass", childclass), Eigen::Isometry3d::Identity(), depth + 1);
    const MjcfBody& done = model_.bodies[at(index)];
    if (done.gravcomp != 0.0) model_.notes.push_back("body " + done.name + ": gravcomp is not modelled");
  }

  void read_joint(const MjcfElement& element, int body, const std::string& childclass, const Eigen::Isometry3d& frame) {
    if (body == 0) element.fail("a joint of the world; put it into a body");
    limit(element, joint_count_++);
    const MjcfElement full = element.name == "joint" ? defaults_.resolved(element, childclass) : element;
    MjcfJoint joint = read_mjcf_joint(full, model_.compiler, frame, model_.notes);
    MjcfBody& owner = model_.bodies[at(body)];
    if (joint.kind == MjcfJointKind::kFree && (owner.parent != 0 || !owner.joints.empty()))
      element.fail("a free joint is for a body of the world that has no other joint");
    joint.qpos = model_.qpos_count;
    model_.qpos_count += qpos_size(joint.kind);
    owner.joints.push_back(std::move(joint));
    if (owner.parent == 0 && floats_in_parts(owner.joints)) {
      MjcfJoint free;
      free.kind = MjcfJointKind::kFree;
      free.qpos = owner.joints.front().qpos;
      free.element = owner.joints.front().element;
      owner.joints = {std::move(free)};
      model_.notes.push_back("body " + owner.name + ": its three slides and its ball are taken for the free joint that they are together");
    }
  }

  // Three slides at right angles and a ball, none with an end: a free joint, written as some simulators did before there was one.
  static bool floats_in_parts(const std::vector<MjcfJoint>& joints) {
    if (joints.size() != 4 || joints[3].kind != MjcfJointKind::kBall) return false;
    Eigen::Matrix3d axes;
    for (std::size_t i = 0; i < 3; ++i) {
      if (joints[i].kind != MjcfJointKind::kSlide || joints[i].limited) return false;
      axes.col(static_cast<Eigen::Index>(i)) = joints[i].axis;
    }
    return (axes.transpose() * axes).isIdentity(1e-6);
  }

  static void limit(const MjcfElement& element, std::size_t there_are) {
    if (there_are >= kMostOfAKind)
      element.fail("there are more than " + std::to_string(kMostOfAKind) + " of this kind; simplify the model");
  }

  void count(const MjcfElement& element) {
    if (++parts_ > kMostParts) element.fail("there are more than " + std::to_string(kMostParts) + " geoms and sites");
  }

  // Names are per kind in MJCF.
  void check_twice() {
    std::set<std::string> bodies, joints, geoms;
    const auto once = [](std::set<std::string>& seen, const std::string& name, const MjcfElement& element) {
      if (!name.empty() && !seen.insert(name).second) element.fail("the name is there twice; rename one");
    };
    for (const MjcfBody& body : model_.bodies) {
      if (&body != model_.bodies.data()) once(bodies, body.name, body.element);
      for (const MjcfJoint& joint : body.joints) {
        once(joints, joint.name, joint.element);
        if (!joint.name.empty()) joints_.emplace(joint.name, &joint);
      }
      for (const MjcfGeom& geom : body.geoms) once(geoms, geom.name, geom.element);
    }
  }

  const MjcfJoint& need_joint(const MjcfElement& element, const std::string& key, const std::string& name) const {
    const auto found = joints_.find(name);
    if (found != joints_.end()) return *found->second;
    std::vector<std::string> known;
    for (const auto& each : joints_) known.push_back(each.first);
    element.fail(key, "names " + name.substr(0, 60) + ", which is no joint" + suggestion(name, known));
  }

  void need_body(const MjcfElement& element, const std::string& key) const {
    const std::string name = element.text(key);
    if (model_.find_body(name) >= 0) return;
    element.fail(key, "names " + name.substr(0, 60) + ", which is no body" + suggestion(name, model_.bodies));
  }

  void read_contact(const MjcfElement& element) {
    if (element.name == "exclude") {
      need_body(element, "body1");
      need_body(element, "body2");
      limit(element, model_.excludes.size());
      model_.excludes.emplace_back(element.text("body1"), element.text("body2"));
    }
    if (element.name != "pair") return;
    limit(element, pairs_++);
    const MjcfElement full = defaults_.resolved(element, "");
    const std::string first = element.text("geom1"), second = element.text("geom2");
    read_pair(full, first, is_ground(second));
    read_pair(full, second, is_ground(first));
  }

  // It touches whatever contype and conaffinity say; on the ground in its own way, of several pairs by the one with the most friction.
  void read_pair(const MjcfElement& element, const std::string& name, bool on_ground) {
    for (MjcfBody& body : model_.bodies) {
      for (MjcfGeom& geom : body.geoms) {
        if (name.empty() || geom.name != name) continue;
        const MjcfSurface said = read_mjcf_pair(element);
        geom.touches = true;
        if (!on_ground) continue;
        if (!paired_.insert(name).second && said.contact.friction[0] < geom.surface.contact.friction[0]) continue;
        geom.surface = said;
        geom.friction = said.contact.friction[0];
      }
    }
  }

  // A geom of the world, or of the file that includes this one.
  bool is_ground(const std::string& name) const {
    const auto has = [&](const MjcfBody& body) {
      return std::any_of(body.geoms.begin(), body.geoms.end(), [&](const MjcfGeom& geom) { return geom.name == name; });
    };
    return std::none_of(std::next(model_.bodies.begin()), model_.bodies.end(), has);
  }

  // Every geom of a body with the first plane of the world, or what else is there that touches.
  void put_on_ground() {
    const MjcfGeom* ground = nullptr;
    for (const MjcfGeom& geom : model_.bodies[0].geoms) {
      const bool first = ground == nullptr || (ground->kind != MjcfGeomKind::kPlane && geom.kind == MjcfGeomKind::kPlane);
      if (first && geom.touches) ground = &geom;
    }
    if (ground == nullptr) return;
    for (auto body = std::next(model_.bodies.begin()); body != model_.bodies.end(); ++body) {
      for (MjcfGeom& geom : body->geoms) geom.surface = touching(geom.surface, ground->surface);
    }
  }

  void read_equality(const MjcfElement& given) {
    const MjcfElement element = defaults_.resolved(given, "");
    if (!element.flag("active", true)) return;
    limit(element, model_.mimics.size());
    if (element.name == "joint") {
      const MjcfJoint& joint = need_joint(element, "joint1", element.text("joint1"));
      const std::vector<double> poly = element.numbers("polycoef", 1, 5, 1e6);
      const auto coefficient = [&](std::size_t i) { return poly.size() > i ? poly[i] : i == 1 ? 1.0 : 0.0; };
      const std::string follows = element.text("joint2");
      if (follows.empty() || coefficient(2) != 0.0 || coefficient(3) != 0.0 || coefficient(4) != 0.0 || coefficient(1) == 0.0)
        element.fail("only a joint that follows another one linearly is read (joint2, polycoef a b 0 0 0)");
      // MuJoCo counts both from ref, and so does a URDF made of it.
      (void)need_joint(element, "joint2", follows);
      model_.mimics.push_back({joint.name, follows, coefficient(0), coefficient(1)});
    } else if (element.name == "connect" || element.name == "weld") {
      element.fail("a loop (" + element.name + ") is not read; name it in `loops` of robot.yaml after taking it out here");
    } else if (element.name != "include") {
      model_.notes.push_back("equality " + element.name + " is not modelled: left out");
    }
  }

  void read_key(const MjcfElement& element) {
    if (element.name != "key") return;
    MjcfKey key;
    key.element = element;
    key.name = element.text("name", "key" + std::to_string(model_.keys.size()));
    key.qpos = element.numbers("qpos", 0, 100'000, 1e9);
    if (key.qpos.empty()) return;
    limit(element, model_.keys.size());
    if (static_cast<int>(key.qpos.size()) != model_.qpos_count) {
      element.fail("qpos", "has " + std::to_string(key.qpos.size()) + " numbers; the model has " +
                               std::to_string(model_.qpos_count));
    }
    model_.keys.push_back(std::move(key));
  }

  void read_sensor(const MjcfElement& element) {
    if (!model_.imu_site.empty()) return;
    if (element.name == "gyro" || element.name == "accelerometer") model_.imu_site = element.text("site");
  }

  void read_options() {
    for (const MjcfElement& option : root_.children) {
      if (option.name != "option") continue;
      const Eigen::Vector3d gravity = option.vector("gravity", {0.0, 0.0, -9.81}, 1e6);
      if (!gravity.isApprox(Eigen::Vector3d(0.0, 0.0, -9.81)))
        model_.notes.push_back("the model's gravity is another than 0 0 -9.81: here it is that");
      MujocoConfig& of_solver = model_.option;
      for (const auto& [key, count] : {std::pair{"iterations", &of_solver.iterations}, {"ls_iterations", &of_solver.ls_iterations},
                                       {"noslip_iterations", &of_solver.noslip_iterations}})
        *count = std::clamp(option.whole(key, *count), 0, kMostIterations);
      of_solver.elliptic = option.choice("cone", {"pyramidal", "elliptic"}, of_solver.elliptic ? 1 : 0) == 1;
      of_solver.impratio = option.number("impratio", of_solver.impratio, 1e-3, 1e6);
      for (const char* key : {"density", "viscosity"}) {
        if (option.number(key, 0.0, 0.0, 1e9) > 0.0)
          model_.notes.push_back(std::string("the fluid around the model (") + key + ") is not modelled");
      }
    }
  }

  const MjcfElement& root_;
  MjcfDefaults defaults_;
  MjcfModel model_;
  std::map<std::string, const MjcfJoint*> joints_;
  std::set<std::string> paired_;  // geoms in a <pair> with the ground
  std::size_t pairs_ = 0;
  std::size_t parts_ = 0, joint_count_ = 0;
  int tendons_ = 0;
};

}  // namespace

int MjcfModel::find_body(const std::string& body) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].name == body) return static_cast<int>(i);
  }
  return -1;
}

MjcfModel read_mjcf_model_text(const std::string& text, const std::string& file) {
  const MjcfDocument document = read_mjcf_text(text, file);
  return Reader(document).read();
}

MjcfModel read_mjcf_model(const std::string& file) {
  const MjcfDocument document = read_mjcf(file);
  return Reader(document).read();
}

}  // namespace twinbus::robot
