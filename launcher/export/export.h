// `twinbus export SCENE --to mjcf|urdf`: a scene as files that MuJoCo or Drake simulate.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int export_command(const std::vector<std::string>& words);

}  // namespace twinbus
