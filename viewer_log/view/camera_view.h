// The newest whole picture of the robot's camera: JPEG or PNG, from the numbered pieces of CAMERA.
//
// Pieces of one picture share sender and time; a picture of which a piece is missing is left out.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline viewer_log {

inline constexpr std::int8_t kCameraPicture = 8;  // kind of a model_text_t that is one

class CameraView {
 public:
  void on_piece(const ModelTextPiece& piece, std::int64_t now_ns);

  std::int64_t version() const { return version_; }  // counts up by one per whole picture
  std::int64_t at_ns() const { return at_ns_; }      // when the newest became whole; 0: never
  const std::string& picture() const { return picture_; }
  const char* type() const;  // "image/jpeg", "image/png", or "" for bytes that are neither
  // For the page; the picture as a data: address.
  std::string frame() const;

 private:
  std::int64_t sender_ = 0, taken_ = 0;  // of the picture that is being put together
  std::int32_t size_ = 0;
  std::vector<std::string> pieces_;
  std::size_t have_ = 0;
  std::string picture_;
  std::int64_t version_ = 0, at_ns_ = 0;
};

}  // namespace twinbus::viewer_log
