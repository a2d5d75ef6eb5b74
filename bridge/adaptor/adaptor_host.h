// Loads an adaptor from a shared object.
//
// A name is looked for in the installation (lib/adaptors beside the program's folder), a path is
// taken as it is; never in a robot's folder, because robot folders are data.

#pragma once

#include <string>
#include <vector>

#include "bridge/adaptor/adaptor.h"
#include "bridge/adaptor/adaptor_abi.h"

namespace twinbus::inline bridge {

// Of this installation: <folder of the program>/../lib/adaptors.
std::string adaptor_folder();
// Names of what lies there.
std::vector<std::string> installed_adaptors();

class LoadedAdaptor {
 public:
  // Throws std::runtime_error with one sentence: not found, not an adaptor, built for another
  // version.
  explicit LoadedAdaptor(const std::string& name_or_path);
  ~LoadedAdaptor();
  LoadedAdaptor(const LoadedAdaptor&) = delete;
  LoadedAdaptor& operator=(const LoadedAdaptor&) = delete;

  RobotAdaptor& operator*() const noexcept { return *adaptor_; }
  RobotAdaptor* operator->() const noexcept { return adaptor_; }
  // The object and its code stay where they are for the rest of the process: a thread hangs inside.
  void abandon() noexcept { abandoned_ = true; }

 private:
  void* library_ = nullptr;
  const TwinbusAdaptorAbi* abi_ = nullptr;
  RobotAdaptor* adaptor_ = nullptr;
  bool abandoned_ = false;
};

}  // namespace twinbus::bridge
