// biped12 whose ankles are turned by two motors each, over cranks and rods: test/parallel/parallel_ankles.yaml.

#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "robot/description/load.h"

namespace twinbus::test {

inline std::string parallel_ankles_text() {
  const std::filesystem::path file = std::filesystem::path(config_folder()).parent_path() / "test" / "parallel" / "parallel_ankles.yaml";
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

// biped12 with more text in its robot.yaml.
inline Model biped12_with(const std::string& yaml) {
  const Model plain = load_robot("biped12");
  return load_robot_texts({.folder = plain.folder, .yaml = plain.yaml_text + yaml, .urdf = plain.urdf_text, .srdf = plain.srdf_text});
}

inline const Model& parallel_biped() {
  static const Model model = biped12_with(parallel_ankles_text());
  return model;
}

}  // namespace twinbus::test
