#include "robot/description/mujoco_config.h"

#include "common/text/formatted.h"
#include "common/text/strict_yaml.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

namespace {

constexpr int kMostIterations = 10'000;

template <std::size_t N>
std::array<double, N> read_numbers(const ConfigNode& node, const std::string& key, const std::array<double, N>& otherwise) {
  const std::vector<double> given = node.numbers(key, N, {otherwise.begin(), otherwise.end()});
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    if (!(given[i] >= -1e9 && given[i] <= 1e9)) node.fail(key, "must be numbers within 1e9");
    numbers[i] = given[i];
  }
  return numbers;
}

template <std::size_t N>
std::string list(const std::array<double, N>& numbers) {
  std::string out = "[";
  for (std::size_t i = 0; i < N; ++i) out += (i == 0 ? "" : ", ") + formatted("%.10g", numbers[i]);
  return out + "]";
}

MujocoContact read_contact(const ConfigNode& node) {
  MujocoContact contact;
  contact.links = node.texts("links");
  if (contact.links.empty()) node.fail("links", "must name at least one link");
  contact.friction = read_numbers(node, "friction", contact.friction);
  for (const double value : contact.friction) {
    if (!(value >= 0.0 && value <= 1e3)) node.fail("friction", "must be within 0 and 1000");
  }
  contact.condim = static_cast<int>(node.integer("condim", 1, 6, contact.condim));
  if (contact.condim == 2 || contact.condim == 5) node.fail("condim", "must be 1, 3, 4 or 6");
  contact.solref = read_numbers(node, "solref", contact.solref);
  contact.solimp = read_numbers(node, "solimp", contact.solimp);
  node.finish();
  return contact;
}

}  // namespace

const MujocoContact* MujocoConfig::of_link(const Model& model, int link) const {
  const MujocoContact* best = nullptr;
  for (const MujocoContact& contact : contacts) {
    for (const std::string& name : contact.links) {
      for (const Frame& frame : model.frames) {
        if (frame.name == name && frame.link == link && (best == nullptr || contact.friction[0] > best->friction[0]))
          best = &contact;
      }
    }
  }
  return best;
}

MujocoConfig read_mujoco_config(const ConfigNode& node) {
  MujocoConfig config;
  config.iterations = static_cast<int>(node.integer("iterations", 0, kMostIterations, 0));
  config.ls_iterations = static_cast<int>(node.integer("ls_iterations", 0, kMostIterations, 0));
  config.noslip_iterations = static_cast<int>(node.integer("noslip_iterations", 0, kMostIterations, 0));
  config.elliptic = node.choice("cone", {"pyramidal", "elliptic"}, 0) == 1;
  config.impratio = node.number("impratio", 1e-3, 1e6, config.impratio);
  for (const ConfigNode& each : node.list("contacts")) config.contacts.push_back(read_contact(each));
  node.finish();
  return config;
}

std::string mujoco_yaml(const MujocoConfig& config) {
  std::string out;
  const auto count = [&](const char* key, int value) {
    if (value > 0) out += std::string("  ") + key + ": " + std::to_string(value) + "\n";
  };
  count("iterations", config.iterations);
  count("ls_iterations", config.ls_iterations);
  count("noslip_iterations", config.noslip_iterations);
  if (config.elliptic) out += "  cone: elliptic\n";
  if (config.impratio != 1.0) out += "  impratio: " + formatted("%.10g", config.impratio) + "\n";
  if (!config.contacts.empty()) out += "  contacts:\n";
  for (const MujocoContact& contact : config.contacts) {
    std::string links;
    for (const std::string& link : contact.links) links += (links.empty() ? "" : ", ") + link;
    out += "    - {links: [" + links + "], friction: " + list(contact.friction) + ", condim: " +
           std::to_string(contact.condim) + ",\n       solref: " + list(contact.solref) + ", solimp: " + list(contact.solimp) + "}\n";
  }
  if (out.empty()) return out;
  return "\n# Of the MuJoCo model: its solver, and its contacts with the ground; for engine mujoco and export alone.\nmujoco:\n" + out;
}

}  // namespace twinbus::robot
