#include "viewer_log/view/setup_desk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/file/write_file.h"
#include "common/math/pose_math.h"

namespace twinbus::inline viewer_log {

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr double kTurn = 3.14159265358979323846;  // range shown of a joint without limits [rad]

// The line `about: ...` of a scene; a file without one says nothing of itself.
std::string about_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  for (int i = 0; i < 20 && std::getline(stream, line); ++i) {
    if (line.compare(0, 7, "about: ") == 0) return line.substr(7);
  }
  return {};
}

Json scene_list(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  Json list = Json::array();
  for (const fs::path& file : files)
    list.push_back({{"name", file.stem().string()}, {"about", about_line(file)}});
  return list;
}

double to_micro(double value) { return std::round(1e6 * value) / 1e6; }

double to_nano(double value) { return std::round(1e9 * value) / 1e9 + 0.0; }  // as the model's hash; no -0

Json limb_json(const char* kind, const char* side, const std::string& frame, const Eigen::Isometry3d& offset) {
  const Eigen::Vector3d at = offset.translation(), rpy = rpy_from_rotation(offset.linear());
  Json json = {{"kind", kind}, {"side", side}, {"frame", frame}, {"at", Json::array()}, {"rpy", Json::array()}};
  for (int i = 0; i < 3; ++i) {
    json["at"].push_back(to_nano(at[i]));
    json["rpy"].push_back(to_nano(rpy[i]));
  }
  return json;
}

// Soles, hands and IMU as robot.yaml places them: in a link of the URDF.
Json limb_list(const Model& model) {
  Json list = Json::array();
  if (model.yaml_text.empty()) return list;
  const auto in_place = [&](const std::string& place, const Eigen::Isometry3d& frame) {
    return Eigen::Isometry3d(frame_called(model, place, model.folder).in_link.inverse() * frame);
  };
  constexpr std::array<const char*, 2> kSides = {"left", "right"};
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[side];
    if (sole.link < 0) continue;
    Json json = limb_json("sole", kSides[side], sole.place, in_place(sole.place, sole.frame));
    json["edges"] = {{"front", sole.front}, {"back", sole.back}, {"left", sole.left}, {"right", sole.right}};
    list.push_back(json);
  }
  for (const Hand* hand : hands_of(model)) list.push_back(limb_json("hand", hand->name.c_str(), hand->place, in_place(hand->place, hand->frame)));
  const std::string& imu = model.imu_place.empty() ? model.links.front().name : model.imu_place;
  list.push_back(limb_json("imu", "", imu, in_place(imu, model.imu)));
  return list;
}

}  // namespace

std::string setup_choices(const Model& model, const std::string& scenes_folder) {
  Json json = {{"scenes", scene_list(scenes_folder)}, {"engines", {"articulated", "ode", "mujoco"}}};
  json["poses"] = Json::object();
  json["joints"] = Json::array();
  json["links"] = Json::array();
  json["unchecked"] = Json::array();
  for (const NamedPose& pose : model.poses) {
    Json q = Json::object();
    for (std::size_t j = 0; j < model.joints.size() && j < pose.q.size(); ++j)
      q[model.joints[j].name] = to_micro(pose.q[j]);
    json["poses"][pose.name] = q;
  }
  for (const Joint& joint : model.joints) {
    if (joint.mimic >= 0) continue;
    json["joints"].push_back({{"name", joint.name},
                              {"lower", to_micro(std::max(joint.lower, -kTurn))},
                              {"upper", to_micro(std::min(joint.upper, kTurn))}});
  }
  for (const Link& link : model.links) json["links"].push_back(link.name);
  json["frames"] = Json::array();
  for (const Frame& frame : model.frames) json["frames"].push_back(frame.name);
  json["limbs"] = limb_list(model);
  json["robot"] = model.name;
  for (const auto& [a, b] : model.disabled_pairs) {
    json["unchecked"].push_back({model.links[static_cast<std::size_t>(a)].name,
                                 model.links[static_cast<std::size_t>(b)].name});
  }
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string lay_wish(const std::string& folder, const std::string& wish) {
  if (folder.empty()) return "setup: this viewer was not started by ./twinbus up";
  try {
    write_whole(folder + "/setup/wish.json", wish);
  } catch (const std::runtime_error& error) {
    return std::string("setup: ") + error.what();
  }
  return {};
}

}  // namespace twinbus::viewer_log
