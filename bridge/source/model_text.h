// The robot description cut into the numbered pieces of MODEL_TEXT.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

// URDF, SRDF, robot.yaml and, if not empty, the scene; an empty text has no piece.
std::vector<ModelTextPiece> model_text_pieces(const Model& model, const std::string& scene_text,
                                              std::int64_t run_id);

}  // namespace twinbus::bridge
