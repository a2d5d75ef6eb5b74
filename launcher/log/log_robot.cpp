#include "launcher/log/log_robot.h"

#include <exception>
#include <filesystem>
#include <vector>

#include "lcmtypes/bus/wire.h"
#include "robot/description/load.h"
#include "viewer_log/log/log_reader.h"

namespace twinbus::inline launcher {

namespace {
constexpr int kSearched = 200'000;  // events, for the first STATE
}

std::int64_t model_hash_of_log(const std::string& file, const std::string& channel) {
  LogReader reader(file);
  LogEvent event;
  for (int i = 0; i < kSearched && reader.next(event); ++i) {
    RobotState state;
    if (event.channel == channel && decode(event.data, state) == Status::kOk)
      return state.model_hash;
  }
  return 0;
}

std::optional<Model> robot_of_hash(std::int64_t hash, const std::string& asked) {
  std::vector<std::string> names;
  std::error_code error;
  if (!asked.empty()) {
    names.push_back(asked);
  } else {
    for (const auto& entry :
         std::filesystem::directory_iterator(config_folder() + "/robots", error)) {
      if (entry.is_directory(error)) names.push_back(entry.path().string());
    }
  }
  for (const std::string& name : names) {
    try {
      Model model = load_robot(name);
      if (model.hash == hash) return model;
    } catch (const std::exception&) {
      if (!asked.empty()) throw;
    }
  }
  return {};
}

std::string field_with_joint(const std::string& field, const Model& model) {
  const std::size_t bracket = field.find('[');
  if (bracket == std::string::npos) return field;
  const std::string name = field.substr(0, bracket);
  if (name != "q" && name != "qd" && name != "tau" && name != "kp" && name != "kd") return field;
  const auto k = static_cast<std::size_t>(std::stoul(field.substr(bracket + 1)));
  if (k >= model.bus_joints.size()) return field;
  return name + "." + model.joints[static_cast<std::size_t>(model.bus_joints[k])].name;
}

}  // namespace twinbus::launcher
