#include "viewer_log/view/camera_view.h"

#include <cstddef>
#include <string_view>

#include "viewer_log/view/frame_number.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr std::int32_t kLargest = 2 * 1024 * 1024;  // [bytes]

std::string base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < here ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= here ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

void CameraView::on_piece(const ModelTextPiece& piece, std::int64_t now_ns) {
  if (piece.kind != kCameraPicture || piece.size < 1 || piece.size > kLargest || piece.pieces < 1 ||
      piece.piece < 0 || piece.piece >= piece.pieces || piece.count < 1 ||
      piece.count > kModelTextBytes ||
      piece.pieces != (piece.size + kModelTextBytes - 1) / kModelTextBytes) {
    return;
  }
  if (piece.run_id != sender_ || piece.utime != taken_ || piece.size != size_) {
    if (piece.run_id == sender_ && piece.utime < taken_) return;  // overtaken
    sender_ = piece.run_id;
    taken_ = piece.utime;
    size_ = piece.size;
    pieces_.assign(static_cast<std::size_t>(piece.pieces), std::string());
    have_ = 0;
  }
  std::string& slot = pieces_[static_cast<std::size_t>(piece.piece)];
  if (!slot.empty()) return;
  slot.assign(piece.text.data(), static_cast<std::size_t>(piece.count));
  if (++have_ < pieces_.size()) return;
  std::string whole;
  for (const std::string& part : pieces_) whole += part;
  if (whole.size() != static_cast<std::size_t>(size_)) return;
  picture_ = std::move(whole);
  if (*type() == '\0') return picture_.clear();
  at_ns_ = now_ns;
  ++version_;
}

const char* CameraView::type() const {
  if (picture_.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (picture_.starts_with("\x89PNG\r\n")) return "image/png";
  return "";
}

std::string CameraView::frame() const {
  return dump({{"type", "camera"},
               {"image", std::string("data:") + type() + ";base64," + base64(picture_)}});
}

}  // namespace twinbus::viewer_log
