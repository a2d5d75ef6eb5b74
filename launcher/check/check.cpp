// `./twinbus check`: prints what a robot's folder is, tries it, proposes a folder; what is odd is found in robot/onboarding.

#include "launcher/commands/commands.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/math/index.h"
#include "common/process/arguments.h"
#include "common/process/command_word.h"
#include "geometry/bounds/coarse_mesh.h"
#include "launcher/check/check_cells.h"
#include "launcher/check/check_pairs.h"
#include "launcher/check/check_parallel.h"
#include "launcher/check/subject.h"
#include "launcher/check/trained_joints.h"
#include "launcher/check/trial.h"
#include "launcher/check/walk_trial.h"
#include "robot/estimation/point_legs.h"
#include "robot/collision/loop_joints.h"
#include "robot/description/link_points.h"
#include "robot/description/load.h"
#include "robot/description/named_hands.h"
#include "robot/collision/near_pairs.h"
#include "robot/kinematics/kinematics.h"
#include "robot/lint/model_lint.h"
#include "robot/onboarding/proposal.h"

namespace twinbus::inline launcher {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kWalkPatience = 8.0;  // of the processor's time [s]

const char* kind_name(JointKind kind) {
  return kind == JointKind::kPrismatic    ? "prismatic"
         : kind == JointKind::kContinuous ? "continuous"
                                          : "revolute";
}

struct Extent {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Vector3d com = Eigen::Vector3d::Zero();  // from the middle of the box, at its bottom
  int shapes = 0, meshes = 0, links = 0;
  int coarse = 0;  // meshes that the guard sees as their hulls
};

Extent measure(const Model& model) {
  const Kinematics k = at_rest(model);
  Extent extent;
  Eigen::AlignedBox3d box;
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[at(i)];
    for (const Eigen::Vector3d& point : link_points(link)) box.extend(k.link_in_world(i) * point);
    extent.links += link.collision.empty() ? 0 : 1;
    extent.shapes += static_cast<int>(link.collision.size());
    for (const Shape& shape : link.collision) {
      if (shape.kind != ShapeKind::kMesh) continue;
      ++extent.meshes;
      extent.coarse +=
          load_mesh(shape.mesh, shape.size).triangles.size() > at(kFineTriangles) ? 1 : 0;
    }
  }
  if (box.isEmpty()) return extent;
  extent.size = box.sizes();
  extent.com = k.com() - Eigen::Vector3d(box.center().x(), box.center().y(), box.min().z());
  return extent;
}

std::vector<std::string> sensors(const Model& model) {
  std::vector<std::string> found;
  if (!model.yaml_text.empty()) found.push_back("IMU on " + model.links[at(model.imu_link)].name);
  for (const int side : {0, 1}) {
    const std::string name = side == 0 ? "left" : "right";
    const Sole& sole = model.soles[at(side)];
    const Hand& hand = model.hands[at(side)];
    if (sole.link >= 0)
      found.push_back("force, " + name + " foot, on " + model.links[at(sole.link)].name);
    if (hand.link >= 0)
      found.push_back("force, " + name + " hand, on " + model.links[at(hand.link)].name);
  }
  for (const Frame& frame : model.frames) {
    std::string lower = frame.name;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (lower.find("camera") != std::string::npos) {
      found.push_back("camera frame " + frame.name + ", on " + model.links[at(frame.link)].name);
    }
  }
  return found;
}

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json to_json(const std::vector<Suspicion>& all) {
  json list = json::array();
  for (const Suspicion& s : all)
    list.push_back({{"about", s.about}, {"what", s.what}, {"remedy", s.remedy}});
  return list;
}

// The joint of that name whose gains are shown.
const Joint& with_gains(const Joint& joint, const Model& gains) {
  const int known = gains.find_joint(joint.name);
  return known < 0 ? joint : gains.joints[at(known)];
}

json report(const Model& model, const Extent& extent, const Model& gains) {
  json out = {{"name", model.name},
              {"mass_kg", model.total_mass()},
              {"joints", json::array()},
              {"links", model.link_count()},
              {"bus_joints", model.bus_count()},
              {"floating_base", model.floating_base},
              {"size_m", {extent.size.x(), extent.size.y(), extent.size.z()}},
              {"com_above_ground_m", extent.com.z()},
              {"geometry",
               {{"links", extent.links},
                {"shapes", extent.shapes},
                {"meshes", extent.meshes},
                {"meshes_as_hulls", extent.coarse}}},
              {"sensors", sensors(model)},
              {"period_s", model.period()},
              {"model_hash", model.hash}};
  for (const Joint& joint : model.joints) {
    const auto j = static_cast<std::size_t>(&joint - model.joints.data());
    out["joints"].push_back(
        {{"name", joint.name},
         {"kind", kind_name(joint.kind)},
         {"bus", model.bus_index[j]},
         {"lower", number(joint.lower)},
         {"upper", number(joint.upper)},
         {"velocity", number(joint.velocity)},
         {"effort", number(joint.effort)},
         {"rotor_inertia", joint.rotor_inertia},
         {"kp", with_gains(joint, gains).kp},
         {"kd", with_gains(joint, gains).kd},
         {"mimics", joint.mimic < 0 ? json(nullptr) : json(model.joints[at(joint.mimic)].name)}});
  }
  if (const json pairs = parallel_joints_json(model); !pairs.empty()) out["parallel_joints"] = pairs;
  for (const NamedPose& pose : model.poses) out["poses"].push_back(pose.name);
  return out;
}

void print_gripper(const Model& model, const Hand& hand) {
  const Gripper gripper = gripper_of(model, hand);
  if (gripper.joints.empty()) return;
  std::printf("%s gripper:", hand.name.c_str());
  for (std::size_t i = 0; i < gripper.joints.size(); ++i) {
    std::printf("%s %s %.3f closed, %.3f open", i == 0 ? "" : ",", model.joints[at(gripper.joints[i])].name.c_str(),
                gripper.closed[i], gripper.open[i]);
  }
  std::printf("\n");
}

// Where it stands, what it reaches with and what it feels.
void print_limbs(const Model& model) {
  for (const int side : {0, 1}) {
    const char* name = side == 0 ? "left" : "right";
    const Sole& sole = model.soles[at(side)];
    if (sole.link >= 0) {
      std::printf("%s sole on %s: %.0f x %.0f mm, %.3g N/m, %.3g N s/m, friction %.2f\n", name,
                  model.links[at(sole.link)].name.c_str(), 1e3 * (sole.front + sole.back),
                  1e3 * (sole.left + sole.right), sole.stiffness, sole.damping, sole.friction);
    }
    const Hand& hand = model.hands[at(side)];
    if (hand.link >= 0) {
      std::string carriers;
      for (const int j : hand.carriers) carriers += (carriers.empty() ? ", carried by " : ", ") + model.joints[at(j)].name;
      std::printf("%s hand on %s: arm of %zu joints%s\n", name,
                  model.links[at(hand.link)].name.c_str(), hand.joints.size(), carriers.c_str());
      print_gripper(model, hand);
    }
  }
  for (const Hand& arm : model.more_hands) {
    std::printf("%s on %s: arm of %zu joints\n", arm.name.c_str(), model.links[at(arm.link)].name.c_str(), arm.joints.size());
    print_gripper(model, arm);
  }
  if (!model.yaml_text.empty() && stands_on_points(model)) {
    const StandingFeet feet(model);
    std::string names;
    for (int foot = 0; foot < feet.count(); ++foot) names += (foot == 0 ? "" : ", ") + model.links[at(feet.link(foot))].name;
    if (feet.count() > 0) std::printf("point feet: %s\n", names.c_str());
  }
  for (const std::string& sensor : sensors(model)) std::printf("sensor: %s\n", sensor.c_str());
}

// gains: where kp and kd are from; model itself, or what is proposed.
void print(const Model& model, const Extent& extent, const Model& gains) {
  std::printf("%s: %d joints (%d on the bus), %d links, %.1f kg, period %.1f ms, model hash %lld\n",
              model.name.c_str(), model.joint_count(), model.bus_count(), model.link_count(),
              model.total_mass(), 1e3 * model.period(), static_cast<long long>(model.hash));
  std::printf(
      "size %.2f x %.2f x %.2f m in the zero posture, centre of mass %.2f m above its lowest "
      "point\n",
      extent.size.x(), extent.size.y(), extent.size.z(), extent.com.z());
  std::printf("%d links can be touched: %d shapes, %d of them meshes\n", extent.links,
              extent.shapes, extent.meshes);
  if (extent.coarse > 0) {
    std::printf(
        "to the guard %d meshes of more than %d triangles are their convex hulls: it keeps out of "
        "their hollows too\n",
        extent.coarse, kFineTriangles);
  }
  std::printf("%4s  %-28s %-10s %8s %8s %8s %8s %8s %7s\n", "bus", "joint", "kind", "lower",
              "upper", "velocity", "effort", "kp", "kd");
  for (const Joint& joint : model.joints) {
    const int bus = model.bus_index[static_cast<std::size_t>(&joint - model.joints.data())];
    std::printf("%4s  %-28s %-10s %8.3f %8.3f %8.2f %8.1f %8.5g %7.4g\n",
                bus < 0 ? "-" : std::to_string(bus).c_str(), joint.name.c_str(),
                kind_name(joint.kind), joint.lower, joint.upper, joint.velocity, joint.effort,
                with_gains(joint, gains).kp, with_gains(joint, gains).kd);
  }
  if (&gains != &model) std::printf("kp and kd are proposed\n");
  print_limbs(model);
  for (const PassiveJoint& passive : passive_joints_of(model)) {
    std::printf("%s has no motor: a spring of %.3g N m/rad that rests at %.3g rad\n", model.joints[at(passive.joint)].name.c_str(),
                passive.stiffness, passive.rest);
  }
  print_parallel_joints(model);
  const std::string loops = loops_sentence(model);
  if (!loops.empty()) std::printf("%s\n", loops.c_str());
  std::printf("poses:");
  for (const NamedPose& pose : model.poses) std::printf(" %s", pose.name.c_str());
  std::printf("\n%zu pairs of links are declared never to touch\n", model.disabled_pairs.size());
  if (const std::size_t kinds = model.mujoco.contacts.size(); kinds > 0)
    std::printf("engine mujoco: contacts of %zu kinds as robot.yaml says\n", kinds);
  for (const NearPair& pair : model.near_pairs) {
    std::printf("near by design: guards keep %.1f mm of %s and %s\n", 1e3 * pair.margin, model.links[at(pair.link_a)].name.c_str(),
                model.links[at(pair.link_b)].name.c_str());
  }
}

json to_json(const WalkBound& bound) { return {{"most", bound.most}, {"why", bound.why}}; }

json to_json(const Trial& trial, const WalkTrial& walk) {
  return {{"refusal", trial.refusal},
          {"cannot_balance", trial.cannot_balance},
          {"walk",
           {{"why_not", walk.why_not},
            {"leg_m", number(walk.leg)},
            {"fastest_m_s", walk.fastest},
            {"step_m", walk.step},
            {"limit", walk.limit},
            {"slope_deg", to_json(walk.slope_deg)},
            {"push_m_s", to_json(walk.push)},
            {"push_aside_m_s", to_json(walk.push_aside)},
            {"runs", walk.runs},
            {"cpu_s", walk.cpu_s}}},
          {"stood", trial.stood},
          {"simulated_s", trial.simulated_s},
          {"realtime_factor", trial.wall_s > 0.0 ? trial.simulated_s / trial.wall_s : 0.0},
          {"figures", trial.figures},
          {"failures", trial.failures},
          {"weak", trial.weak}};
}

void print(const char* what, const WalkBound& bound, const char* unit, const char* more) {
  print_typed(stdout, "  %s %.3g %s%s%s%s%s\n", what, bound.most, unit, bound.why.empty() ? "" : "; ", bound.why.empty() ? "" : more,
              bound.why.empty() ? "" : ": ", bound.why.c_str());
}

void print_failures(const Trial& trial, const char* remedy) {
  for (const std::string& failure : trial.failures) std::printf("  %s\n", failure.c_str());
  for (const std::string& weak : trial.weak) std::printf("  %s: %s\n", weak.c_str(), remedy);
}

void print(const Trial& trial) {
  std::printf("\n");
  if (!trial.refusal.empty()) return;  // said as the error
  if (!trial.cannot_balance.empty()) {
    if (trial.free) {
      print_typed(stdout, "%s while its servos hold half_sitting; our controller cannot balance it or walk with it: %s.  A controller of "
                  "its own can: ./twinbus policy MODEL.onnx (doc/policy.md), or any program that sends COMMAND (examples/)\n",
                  trial.stood ? "stands only" : "falls", trial.cannot_balance.c_str());
      return;
    }
    if (trial.arm && !trial.stood) {
      std::printf("DOES NOT HOLD its posture (%.1f s in the simulator):\n", trial.simulated_s);
      print_failures(trial, "correct the limit in the URDF, let --mend guess it, or change half_sitting in the SRDF");
      return;
    }
    if (trial.arm) {
      print_typed(stdout, "an arm on %s: arm_hold, arm_reach, arm_scan and arm_pick are its scenes; "
                          "./twinbus up arm holds it for jog, reach and pose\n",
                  trial.planar ? "a base that moves on the plane" : "a fixed base");
      return;
    }
    if (trial.stood) {
      print_typed(stdout, "no arm that reaches, on a fixed base: its joints hold half_sitting in scene stand; ./twinbus up stand holds it, "
                  "./twinbus pose NAME moves it, as does any program that sends COMMAND (examples/)\n");
      return;
    }
    std::printf("does not stand: %s.  Balance wants a free base, and two legs of five to seven joints, each with a sole, or two or four on point feet\n",
                trial.cannot_balance.c_str());
    return;
  }
  if (trial.stood) {
    std::printf("stands: %.1f s in the simulator, %.1f times real time: %s\n", trial.simulated_s,
                trial.simulated_s / std::max(trial.wall_s, 1e-9), trial.figures.c_str());
    return;
  }
  std::printf("DOES NOT STAND (%.1f s in the simulator): %s\n", trial.simulated_s,
              trial.figures.c_str());
  print_failures(trial, "correct the limit in the URDF, or half_sitting in the SRDF");
  std::printf(
      "  see `If it falls` in config/robots/README.md; what is named above as suspicious or to be "
      "looked "
      "at comes first\n");
}

void print(const WalkTrial& walk) {
  if (walk.runs == 0) return;
  if (!walk.why_not.empty()) {
    std::printf("does not walk: %s\n", walk.why_not.c_str());
    return;
  }
  std::printf("%s: %.2f m/s forward, steps of %.2f m, legs of %.2f m (%d walks in %.1f s)%s%s\n", walk.trots ? "trots" : "walks",
              walk.fastest, walk.step, walk.leg, walk.runs, walk.cpu_s, walk.limit.empty() ? "" : "; faster: ", walk.limit.c_str());
  std::printf("at half of that:\n");
  print("up a slope of", walk.slope_deg, "degrees", "steeper");
  print("pushed forward by", walk.push, "m/s", "harder");
  print("pushed to the side by", walk.push_aside, "m/s", "harder");
}

void print(const char* title, const std::vector<Suspicion>& all) {
  std::printf("\n%s: %s\n", title, all.empty() ? "nothing" : "");
  for (const Suspicion& s : all)
    std::printf("  %s: %s; %s\n", s.about.c_str(), s.what.c_str(), s.remedy.c_str());
}

Proposal propose_for(const CheckSubject& subject) {
  Proposal proposal = propose(subject.repaired, subject.source);
  exempt_at_rest(load_proposed(proposal, subject), proposal);
  return proposal;
}

// A robot that has the legs and falls with the gains of its file, but not with those by weight and lever arms, gets these.
// The gains of a model that a policy was trained with are often too soft for a controller that commands positions.
bool own_gains_stand(CheckSubject& subject, const Trial& trial, Proposal& proposal) {
  if (trial.stood || !trial.cannot_balance.empty() || subject.source.servos.empty()) return false;
  subject.source.servos_apply = false;
  Proposal other = propose_for(subject);
  if (!try_to_stand(load_proposed(other, subject)).stood) return false;
  other.doubts.push_back("with the gains of " + subject.source.srdf_origin +
                         " our own balance falls: gains from weight and lever arms are proposed, those of the file stand "
                         "beside them; a policy sends its own with every command");
  proposal = std::move(other);
  return true;
}

// What refuses a file is often what --mend puts right.
CheckSubject subject_asked_for(const std::string& name, bool mends, const std::string& base) try {
  return load_subject(name, mends, base);
} catch (const std::runtime_error& error) {
  if (mends) throw;
  try {
    (void)load_subject(name, true, base);
  } catch (const std::runtime_error&) {
    throw error;
  }
  const std::string faults = error.what();
  const bool several = faults.find('\n') != std::string::npos;
  throw std::runtime_error(faults + (several ? "\nor let --mend put all of it right in a copy" : "; or let --mend put it right in a copy"));
}

}  // namespace

int check_command(const std::vector<std::string>& words) {
  const Arguments arguments({"check", 1, 1, R"(ROBOT
Loads a robot (a name in config/robots, a folder, a URDF file, or an .xml of MuJoCo) with every check of its files.
Prints mass, size, joints, sensors, what is suspicious and what robot.yaml lacks; for a URDF without
robot.yaml, and for a MuJoCo model (MJCF), also proposes one, with a gait found by walking in the simulator.  The robot, or what \
is proposed, stands for two seconds in the simulator.
Exit status 1 if it is refused, with one line naming file and remedy, does not stand though it has the legs, or is an arm that \
does not hold its posture.
  --json  everything as one JSON object
  --pairs  instead: which pairs of links can touch, with proof, and which of those that the SRDF leaves out do
  --cells  instead: finds what links with few joints between them can touch with, and keeps it in the user's cache (seconds; \
      makes the exact check of all pairs faster)
  --write FILE  with --pairs: writes the SRDF with all proved pairs and reasons
  --mend  of a URDF: inertias that no body has, limits and axes that are none, meshes far from where they are drawn, legs \
      whose ranges are no mirror images, left and right exchanged are put right in the copy; each change is said
  --propose FOLDER  writes the proposed robot.yaml and SRDF with a copy of the URDF, or the URDF made of an MJCF model, into \
      FOLDER
  --base KIND  of the proposal: floating, fixed, or planar: it moves on the plane as on omnidirectional wheels, carries its arms \
      to what they do not reach, and is held, jogged and posed by the joints base_x, base_y, base_yaw; without it a robot with \
      legs floats
  --spec SPEC.yaml  with --propose: rotors (armature) and friction of joints that the robot's files do not say are taken from \
      the specification of a policy, so that it walks on the robot of its training)"}, words);
  const std::string base = arguments.text("--base", "");
  if (!base.empty() && base != "floating" && base != "fixed" && base != "planar")
    throw UsageError("check: --base is floating, fixed or planar, not " + base);
  CheckSubject subject = subject_asked_for(arguments.word(0), arguments.has("--mend"), base);
  const Model& model = subject.model;
  if (arguments.has("--pairs")) return check_pairs(model, arguments.text("--write", ""));
  if (arguments.has("--cells")) return check_cells(model);
  const Extent extent = measure(model);
  const std::vector<Suspicion> suspicions = find_suspicions(model);
  std::vector<Suspicion> missing = find_missing(model);
  const std::string folder = arguments.text("--propose", "");
  if (subject.urdf.empty() && !folder.empty())
    throw UsageError("check: --propose wants a URDF or MJCF file; " + arguments.word(0) +
                     " has a robot.yaml already");
  if (const std::string spec = arguments.text("--spec", ""); !spec.empty()) {
    if (folder.empty()) throw UsageError("check: --spec is for --propose FOLDER");
    subject.source.trained = read_trained_joints(spec, subject.repaired);
  }
  std::optional<Proposal> proposal;
  if (!subject.urdf.empty()) {
    proposal = propose_for(subject);
  }
  // Loaded before anything is written: a proposal that is none leaves no folder.
  Model proposed = proposal ? load_proposed(*proposal, subject) : Model();
  Trial trial = try_to_stand(proposal ? proposed : model);
  if (proposal && own_gains_stand(subject, trial, *proposal)) {
    proposed = load_proposed(*proposal, subject);
    trial = try_to_stand(proposed);
  }
  WalkTrial walk;
  if (proposal && trial.stood && trial.cannot_balance.empty()) {
    walk = find_walk(proposed, kWalkPatience);
    if (!walk.walking.empty())
      proposal->yaml += "\n# As it walked best in the simulator; fastest: what commands may ask for [m/s].\nwalking: {" +
                        walk.walking + "}\n";
  }
  if (proposal && !folder.empty()) {
    const fs::path name(subject.source.urdf_name);
    fs::create_directories(folder);
    write_new(fs::path(folder) / "robot.yaml", proposal->yaml);
    write_new(fs::path(folder) / fs::path(name).replace_extension(".srdf"), proposal->srdf);
    write_new(fs::path(folder) / name, subject.text);
  }
  if (proposal && !folder.empty()) proposed = load_robot(fs::absolute(folder).string());
  if (proposal) {  // beside robot.yaml itself, what the proposal leaves open
    missing = {{"robot.yaml", "is not there",
                folder.empty() ? "take the proposal below" : "one is proposed"}};
    for (const Suspicion& s : find_missing(proposed)) missing.push_back(s);
  }
  const Model& gains = proposal ? proposed : model;  // a URDF alone has none
  const bool good = trial.refusal.empty() && (trial.stood || (!trial.arm && !trial.cannot_balance.empty()));
  if (arguments.has("--json")) {
    json out = report(model, extent, gains);
    out["suspicious"] = to_json(suspicions);
    out["missing"] = to_json(missing);
    out["mended"] = subject.mended;
    out["trial"] = to_json(trial, walk);
    if (proposal) {
      out["proposed"] = {{"robot_yaml", proposal->yaml},
                         {"srdf", proposal->srdf},
                         {"urdf", subject.text},
                         {"doubts", proposal->doubts}};
    }
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    return good ? 0 : 1;
  }
  print(model, extent, gains);
  if (arguments.has("--mend")) {
    std::printf("\nmended%s: %s\n", folder.empty() ? " (--propose FOLDER writes it)" : "", subject.mended.empty() ? "nothing" : "");
    for (const std::string& change : subject.mended) std::printf("  %s\n", change.c_str());
  }
  print("suspicious", suspicions);
  print("missing", missing);
  if (proposal) {
    std::printf("\nlook at these before you use the proposal:%s\n",
                proposal->doubts.empty() ? " nothing found" : "");
    for (const std::string& doubt : proposal->doubts) std::printf("  %s\n", doubt.c_str());
    std::printf("\nfound:\n");
    print_limbs(proposed);
    if (folder.empty()) {
      std::printf(
          "\nproposed robot.yaml (--propose FOLDER writes it, with an SRDF and the URDF):\n\n%s",
          proposal->yaml.c_str());
    } else {
      std::printf("\nwritten: %s\n", folder.c_str());
    }
  }
  print(trial);
  print(walk);
  if (proposal && !folder.empty() && trial.stood)
    print_typed(stdout, "next: ./twinbus run %s --robot %s\n", trial.arm ? "arm_reach" : "stand", folder.c_str());
  if (!trial.refusal.empty())
    throw std::runtime_error(arguments.word(0) + " cannot be simulated: " + trial.refusal);
  return good ? 0 : 1;
}

}  // namespace twinbus::launcher
