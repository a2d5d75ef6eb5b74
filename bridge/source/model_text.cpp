#include "bridge/source/model_text.h"

#include <algorithm>

namespace twinbus::inline bridge {

std::vector<ModelTextPiece> model_text_pieces(const Model& model, const std::string& scene_text,
                                              std::int64_t run_id) {
  const std::string* texts[] = {&model.urdf_text, &model.srdf_text, &model.yaml_text, &scene_text};
  std::vector<ModelTextPiece> pieces;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string& text = *texts[k];
    const std::size_t count = (text.size() + kModelTextBytes - 1) / kModelTextBytes;
    for (std::size_t i = 0; i < count; ++i) {
      ModelTextPiece piece;
      piece.run_id = run_id;
      piece.model_hash = model.hash;
      piece.size = static_cast<std::int32_t>(text.size());
      piece.piece = static_cast<std::int16_t>(i);
      piece.pieces = static_cast<std::int16_t>(count);
      piece.kind = static_cast<std::int8_t>(k + 1);
      const std::size_t from = i * kModelTextBytes;
      const std::size_t bytes = std::min<std::size_t>(kModelTextBytes, text.size() - from);
      piece.count = static_cast<std::int16_t>(bytes);
      std::copy_n(text.data() + from, bytes, piece.text.data());
      pieces.push_back(piece);
    }
  }
  return pieces;
}

}  // namespace twinbus::bridge
