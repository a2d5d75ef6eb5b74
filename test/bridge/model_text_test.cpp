#include "bridge/source/model_text.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

TEST(ModelText, PiecesPutTogetherAreTheTexts) {
  Model model;
  model.hash = 99;
  model.urdf_text = std::string(5000, 'u') + "end";
  model.yaml_text = "period: 0.002";
  const auto pieces = model_text_pieces(model, "about: a scene", 42);
  std::string texts[5];
  for (const ModelTextPiece& piece : pieces) {
    EXPECT_EQ(piece.run_id, 42);
    EXPECT_EQ(piece.model_hash, 99);
    EXPECT_LT(piece.piece, piece.pieces);
    texts[piece.kind].append(piece.text.data(), static_cast<std::size_t>(piece.count));
    EXPECT_LE(texts[piece.kind].size(), static_cast<std::size_t>(piece.size));
  }
  EXPECT_EQ(texts[1], model.urdf_text);
  EXPECT_EQ(texts[2], "");
  EXPECT_EQ(texts[3], model.yaml_text);
  EXPECT_EQ(texts[4], "about: a scene");
}

}  // namespace
}  // namespace twinbus
