#include "robot/mjcf/mjcf_names.h"

#include <map>

#include "robot/names/known_names.h"

namespace twinbus::inline robot {

namespace {

using Names = std::vector<const char*>;

struct Row {
  Names attributes, children;
};

Names joined(Names a, const Names& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Names kPlace = {"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};
const Names kBodyParts = {"body", "frame", "joint", "freejoint", "inertial", "geom", "site", "camera", "light",
                          "composite", "flexcomp", "replicate", "attach", "plugin"};
const Names kActuators = {"general", "motor", "position", "velocity", "intvelocity", "orientation", "pid", "damper",
                          "cylinder", "muscle", "adhesion", "dcmotor", "plugin"};
// One list for all kinds of actuators: the kinds differ in what they ignore.
const Names kActuatorNames = {
    "name", "class", "group", "nsample", "interp", "delay", "ctrlrange", "user", "ctrllimited", "forcelimited", "actlimited",
    "forcerange", "actrange", "lengthrange", "gear", "damping", "armature", "cranklength", "joint", "jointinparent",
    "tendon", "slidersite", "cranksite", "site", "refsite", "body", "actdim", "input", "velrange", "ffrange", "posrange",
    "dyntype", "gaintype", "biastype", "dynprm", "gainprm", "biasprm", "actearly", "kp", "kv", "ki", "imax", "slewmax",
    "dampratio", "inheritrange", "timeconst", "area", "diameter", "bias", "gain", "range", "force", "scale", "lmin", "lmax",
    "vmax", "fpmax", "fvmax", "motorconst", "resistance", "nominal", "saturation", "inductance", "cogging", "controller",
    "thermal", "lugre", "plugin", "instance"};
const Names kEquality = {"name", "class", "active", "solref", "solimp", "body1", "body2", "anchor", "relpose", "torquescale",
                         "site1", "site2", "joint1", "joint2", "polycoef", "tendon1", "tendon2", "flex", "cell"};

std::map<std::string, Row> make_rows() {
  std::map<std::string, Row> rows = {
      {"mujoco",
       {{"model"},
        {"compiler", "option", "size", "statistic", "visual", "default", "custom", "extension", "asset", "worldbody",
         "deformable", "contact", "tendon", "equality", "actuator", "sensor", "keyframe"}}},
      {"compiler",
       {{"autolimits", "boundmass", "boundinertia", "settotalmass", "balanceinertia", "strippath", "coordinate", "angle",
         "fitaabb", "eulerseq", "meshdir", "texturedir", "discardvisual", "usethread", "fusestatic", "inertiafromgeom",
         "inertiagrouprange", "saveinertial", "assetdir", "alignfree", "conflict", "convexhull", "exactmeshinertia"},
        {"lengthrange"}}},
      {"default",
       {{"class"},
        joined({"default", "mesh", "material", "joint", "geom", "site", "camera", "light", "pair", "equality", "tendon"},
               kActuators)}},
      {"asset", {{}, {"mesh", "hfield", "skin", "texture", "material", "model"}}},
      {"mesh",
       {{"name", "class", "content_type", "file", "vertex", "normal", "texcoord", "face", "refpos", "refquat", "scale",
         "smoothnormal", "maxhullvert", "inertia", "builtin", "params", "material"},
        {"plugin"}}},
      {"worldbody", {{}, kBodyParts}},
      {"body", {joined({"name", "childclass", "mocap", "gravcomp", "sleep", "simple", "user"}, kPlace), kBodyParts}},
      {"frame", {joined({"name", "childclass"}, kPlace), kBodyParts}},
      {"inertial", {joined({"mass", "diaginertia", "fullinertia"}, kPlace), {}}},
      {"joint",
       {{"name", "class", "type", "group", "pos", "axis", "springdamper", "limited", "actuatorfrclimited", "solreflimit",
         "solimplimit", "solreffriction", "solimpfriction", "stiffness", "range", "actuatorfrcrange", "actuatorgravcomp",
         "margin", "ref", "springref", "armature", "damping", "frictionloss", "user"},
        {}}},
      {"freejoint", {{"name", "group", "align"}, {}}},
      {"geom",
       {joined({"name", "class", "type", "contype", "conaffinity", "condim", "group", "priority", "size", "material",
                "friction", "mass", "density", "shellinertia", "solmix", "solref", "solimp", "margin", "gap", "surfacevel",
                "adhesion", "fromto", "hfield", "mesh", "fitscale", "rgba", "fluidshape", "fluidcoef", "user"},
               kPlace),
        {"plugin"}}},
      {"site", {joined({"name", "class", "type", "group", "material", "size", "fromto", "rgba", "user"}, kPlace), {}}},
      {"contact", {{}, {"pair", "exclude"}}},
      {"pair",
       {{"name", "class", "geom1", "geom2", "condim", "friction", "solref", "solreffriction", "solimp", "gap", "margin",
         "adhesion"},
        {}}},
      {"exclude", {{"name", "body1", "body2"}, {}}},
      {"equality",
       {{}, {"connect", "weld", "joint", "tendon", "flex", "flexvert", "flexstrain", "distance"}}},
      {"actuator", {{}, kActuators}},
      {"keyframe", {{}, {"key"}}},
      {"key", {{"name", "time", "qpos", "qvel", "act", "ctrl", "mpos", "mquat"}, {}}}};
  for (const char* kind : {"connect", "weld", "joint", "tendon"}) rows[std::string("equality/") + kind] = {kEquality, {}};
  for (const char* kind : kActuators) {
    if (std::string(kind) != "include") rows[std::string("actuator/") + kind] = {kActuatorNames, {"plugin"}};
  }
  for (auto& [context, row] : rows) row.children.push_back("include");
  return rows;
}

const std::map<std::string, Row>& rows() {
  static const std::map<std::string, Row> made = make_rows();
  return made;
}

bool is_actuator(const std::string& element) {
  return rows().count("actuator/" + element) != 0;
}

}  // namespace

std::string mjcf_context(const std::string& parent, const std::string& element) {
  if (parent.empty() || element == "plugin" || element == "include") return "";
  std::string context = element;
  if (parent == "equality") context = "equality/" + element;
  if (parent == "actuator" || (parent == "default" && is_actuator(element))) context = "actuator/" + element;
  const bool part_of_default = parent == "default" && (element == "tendon" || element == "equality");
  return part_of_default || rows().count(context) == 0 ? "" : context;
}

void check_mjcf_names(const XmlElement& element, const std::string& context, const std::string& file,
                      std::vector<std::string>& notes) {
  const auto found = rows().find(context);
  if (found == rows().end()) return;
  KnownElement known{.name = element.name.c_str(), .attributes = found->second.attributes, .children = {}};
  for (const char* child : found->second.children)
    known.children.push_back({.name = child, .attributes = {}, .children = {}, .open = true});
  check_names(element, known, file, notes);
}

}  // namespace twinbus::robot
