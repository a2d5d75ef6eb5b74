#include "bridge/adaptor/adaptor_host.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace twinbus::inline bridge {

namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

std::string find(const std::string& name_or_path) {
  if (name_or_path.empty()) {
    throw std::runtime_error("adaptor: no name given; installed are: " +
                             joined(installed_adaptors()));
  }
  if (name_or_path.find('/') != std::string::npos) return name_or_path;
  const fs::path file = fs::path(adaptor_folder()) / (name_or_path + ".so");
  if (!fs::exists(file)) {
    throw std::runtime_error("adaptor '" + name_or_path + "' is not in " + adaptor_folder() +
                             "; installed are: " + joined(installed_adaptors()) +
                             "; or give a path");
  }
  return file.string();
}

void check(const std::string& what, std::uint32_t theirs, std::uint32_t ours,
           const std::string& file) {
  if (theirs == ours) return;
  throw std::runtime_error("adaptor " + file + ": its " + what + " is " + std::to_string(theirs) +
                           ", this program's is " + std::to_string(ours) +
                           "; build the adaptor again");
}

}  // namespace

std::string adaptor_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return (program.parent_path().parent_path() / "lib" / "adaptors").string();
}

std::vector<std::string> installed_adaptors() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(adaptor_folder(), error)) {
    if (entry.path().extension() == ".so") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

LoadedAdaptor::LoadedAdaptor(const std::string& name_or_path) {
  const std::string file = find(name_or_path);
  library_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr) throw std::runtime_error(std::string("adaptor: ") + ::dlerror());
  try {
    const auto abi =
        reinterpret_cast<TwinbusAdaptorAbiFunction>(::dlsym(library_, "twinbus_adaptor_abi"));
    if (abi == nullptr) {
      throw std::runtime_error("adaptor " + file +
                               ": not an adaptor; it lacks TWINBUS_ADAPTOR(Class)");
    }
    abi_ = abi();
    check("mark", abi_->magic, kAdaptorMagic, file);
    check("version", abi_->version, kAdaptorVersion, file);
    check("state size", abi_->state_size, sizeof(RobotState), file);
    check("command size", abi_->command_size, sizeof(JointCommand), file);
    check("model size", abi_->model_size, sizeof(Model), file);
    check("config size", abi_->config_size, sizeof(AdaptorConfig), file);
    check("imposed state size", abi_->imposed_size, sizeof(ImposedState), file);
    adaptor_ = abi_->create();
    if (adaptor_ == nullptr) throw std::runtime_error("adaptor " + file + ": could not be made");
  } catch (...) {
    ::dlclose(library_);
    throw;
  }
}

LoadedAdaptor::~LoadedAdaptor() {
  if (abandoned_) return;
  abi_->destroy(adaptor_);
  ::dlclose(library_);
}

}  // namespace twinbus::bridge
