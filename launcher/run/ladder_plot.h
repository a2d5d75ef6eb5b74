// Pictures of a choice: error against cost of every run of a ladder, and what of a scene is modelled.  Shapes and strokes tell things
// apart, not colours.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "launcher/run/ladder.h"

namespace twinbus::inline launcher {

// Both axes logarithmic.  error: asked for [m], 0: none.  chosen: of the rungs, -1: none.
std::string front_svg(const std::string& title, const Ladder& ladder, int chosen, double error);

// A part of a scene.
struct ModelledPart {
  std::string name;
  std::string moves;        // how far, in words
  double way = 0.0;         // of what is behind it [m]; negative: it has none
  std::string modelled;     // how, in words
  bool left_out = false;
};

// costs: of parts of the physics, in words and [ms per simulated s].
std::string parts_svg(const std::string& title, const std::vector<ModelledPart>& parts, double error,
                      const std::vector<std::pair<std::string, double>>& costs);

}  // namespace twinbus::launcher
