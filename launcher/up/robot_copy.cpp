#include "launcher/up/robot_copy.h"

#include <yaml-cpp/yaml.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/file/write_file.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "launcher/stack/run_folder.h"

namespace twinbus::inline launcher {

void refuse_change(const std::string& why) { throw std::runtime_error(why); }

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr std::array<const char*, 4> kEdges = {"front", "back", "left", "right"};
constexpr double kFinest = 1e-9;  // a place or angle below this is none [m, rad]

std::string emitted(const YAML::Node& node) {
  YAML::Emitter emitter;
  emitter << node;
  return std::string(emitter.c_str()) + "\n";
}

std::string number_text(const Json& json, const std::string& what) {
  const double value = json.is_number() ? json.get<double>() : std::nan("");
  if (!std::isfinite(value)) refuse_change(what + " must be a finite number");
  return formatted("%.9g", value);
}

// Three numbers of the limb into the node; none where all are zero.
void put_triple(const Json& limb, const char* key, const std::string& what, YAML::Node node) {
  const auto found = limb.find(key);
  if (found == limb.end()) return;
  if (!found->is_array() || found->size() != 3) refuse_change(what + ": " + key + " must be three numbers");
  YAML::Node triple(YAML::NodeType::Sequence);
  triple.SetStyle(YAML::EmitterStyle::Flow);
  bool zero = true;
  for (const Json& part : *found) {
    triple.push_back(number_text(part, what + ": " + key));
    zero = zero && std::abs(part.get<double>()) < kFinest;
  }
  if (zero) node.remove(key);
  else node[key] = triple;
}

void put_place(const Json& limb, const std::string& what, YAML::Node node) {
  if (const auto frame = limb.find("frame"); frame != limb.end()) {
    if (!frame->is_string()) refuse_change(what + ": frame must be the name of a link");
    for (const char c : frame->get<std::string>()) {
      if (std::iscntrl(static_cast<unsigned char>(c)) != 0)
        refuse_change(what + ": frame must be the name of a link, without control characters");
    }
    if (!node["frame"] || node["frame"].as<std::string>() != frame->get<std::string>()) {
      node["frame"] = frame->get<std::string>();
      node.remove("sensor");
    }
  }
  put_triple(limb, "at", what, node);
  put_triple(limb, "rpy", what, node);
}

void refuse_other_keys(const Json& json, const std::string& what, std::initializer_list<const char*> known) {
  if (!json.is_object()) refuse_change(what + " must be an object");
  for (const auto& [key, value] : json.items()) {
    bool good = false;
    for (const char* name : known) good = good || key == name;
    if (!good) refuse_change(what + ": '" + key + "' is not known");
  }
}

void put_limbs(const Json& limbs, const char* key, YAML::Node yaml) {
  const auto found = limbs.find(key);
  if (found == limbs.end()) return;
  const bool soles = std::string(key) == "soles";
  if (soles) refuse_other_keys(*found, key, {"left", "right"});
  else if (!found->is_object()) refuse_change(std::string(key) + " must be an object");
  for (const auto& [side, limb] : found->items()) {
    const std::string what = std::string(key) + ": " + side;
    if (soles) refuse_other_keys(limb, what, {"frame", "at", "rpy", "front", "back", "left", "right"});
    else refuse_other_keys(limb, what, {"frame", "at", "rpy"});
    if (!yaml[key] || !yaml[key][side]) refuse_change(what + ": the robot has none");
    YAML::Node node = yaml[key][side];
    put_place(limb, what, node);
    for (const char* edge : kEdges) {
      if (const auto length = limb.find(edge); length != limb.end()) node[edge] = number_text(*length, what + ": " + edge);
    }
  }
}

// `imu: FRAME` where the IMU is at the frame itself, else a map.
void put_imu(const Json& limbs, YAML::Node yaml) {
  const auto imu = limbs.find("imu");
  if (imu == limbs.end()) return;
  refuse_other_keys(*imu, "imu", {"frame", "at", "rpy"});
  YAML::Node node(YAML::NodeType::Map);
  node.SetStyle(YAML::EmitterStyle::Flow);
  if (yaml["imu"] && yaml["imu"].IsMap()) node = YAML::Clone(yaml["imu"]);
  else if (yaml["imu"]) node["frame"] = yaml["imu"].as<std::string>();
  put_place(*imu, "imu", node);
  if (!node["frame"]) refuse_change("imu: frame must be the name of a link");
  if (node.size() == 1) yaml["imu"] = node["frame"].as<std::string>();
  else yaml["imu"] = node;
}

// What lies outside of the robot's folder is named from anywhere; package://FOLDER is the old folder where the new one has
// another name.
void fit_packages(const fs::path& from, const fs::path& to, YAML::Node yaml) {
  const fs::path own = fs::weakly_canonical(from);
  if (yaml["packages"]) {
    for (auto package : yaml["packages"]) {
      const fs::path folder = fs::weakly_canonical(own / package.second.as<std::string>());
      if (folder.lexically_relative(own).string().starts_with("..")) package.second = folder.string();
    }
  }
  const std::string name = own.filename().string();
  if (to.filename() != name && !(yaml["packages"] && yaml["packages"][name])) yaml["packages"][name] = own.string();
}

}  // namespace

void copy_robot(const std::string& from, const std::string& to, const std::string& robot_name, const RobotChange& change) {
  const fs::path folder = to;
  fs::remove_all(folder);
  fs::copy(from, folder, fs::copy_options::recursive);
  std::string text = read_text_file(folder / "robot.yaml");
  if (!change.limbs.empty()) text = edited_robot_yaml(text, change.limbs);
  YAML::Node yaml = YAML::Load(text);
  fit_packages(from, folder, yaml);
  const std::string name = yaml["srdf"] ? yaml["srdf"].as<std::string>() : "set_up.srdf";
  const std::string old = yaml["srdf"] ? read_text_file(folder / name) : std::string();
  yaml["srdf"] = name;
  write_file(folder / "robot.yaml", emitted(yaml));
  write_file(folder / name, edited_srdf(old, robot_name, change.unchecked, kPagePose, change.joints));
}

std::string edited_robot_yaml(const std::string& yaml_text, const std::string& limbs_text) {
  const Json limbs = Json::parse(limbs_text, nullptr, false);
  refuse_other_keys(limbs, "limbs", {"soles", "hands", "imu"});
  YAML::Node yaml = YAML::Load(yaml_text);
  put_limbs(limbs, "soles", yaml);
  put_limbs(limbs, "hands", yaml);
  put_imu(limbs, yaml);
  return emitted(yaml);
}

std::string edited_srdf(const std::string& srdf, const std::string& robot,
                        const std::vector<std::array<std::string, 2>>& unchecked,
                        const std::string& pose,
                        const std::vector<std::pair<std::string, double>>& joints) {
  std::string text = srdf.empty() ? "<robot name=\"" + robot + "\">\n</robot>\n" : srdf;
  const std::string element = "<disable_collisions";
  for (std::size_t at = 0; (at = text.find(element, at)) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) break;
    const std::string closing = "</disable_collisions>";
    std::size_t next = end + 1;
    if (text[end - 1] != '/') {
      const std::size_t closed = text.find(closing, end);
      if (closed == std::string::npos) break;
      next = closed + closing.size();
    }
    text.erase(at, next - at);
  }
  std::string more;
  for (const auto& [a, b] : unchecked)
    more += "  " + element + " link1=\"" + a + "\" link2=\"" + b + "\" reason=\"User\"/>\n";
  if (!joints.empty()) {
    more += "  <group_state name=\"" + pose + "\" group=\"all\">\n";
    for (const auto& [name, value] : joints) {
      more += "    <joint name=\"" + name + formatted("\" value=\"%.12g\"/>\n", value);
    }
    more += "  </group_state>\n";
  }
  const std::size_t end = text.rfind("</robot>");
  if (end == std::string::npos) refuse_change("the SRDF has no </robot>");
  return text.insert(end, more);
}

}  // namespace twinbus::launcher
