#include "viewer_log/server/web_path.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <random>
#include <system_error>
#include <utility>

namespace twinbus::inline viewer_log {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestTarget = 1024;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// No segment may begin with a dot: that covers "..", "." and hidden files.
bool plain_segments(std::string_view path) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto c = static_cast<unsigned char>(path[i]);
    if (c < 0x20 || c == 0x7f || c == '\\') return false;
    if (c == '.' && path[i - 1] == '/') return false;  // path[0] is '/', so i > 0 here
  }
  return true;
}

bool is_below(const fs::path& file, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && rest != file.end();
}

}  // namespace

bool decode_target(std::string_view target, std::string& path) {
  path.clear();
  if (target.size() > kLongestTarget) return false;
  target = target.substr(0, target.find_first_of("?#"));
  if (target.empty() || target.front() != '/') return false;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (target[i] != '%') {
      path.push_back(target[i]);
      continue;
    }
    if (i + 2 >= target.size()) return false;
    const int high = hex_digit(target[i + 1]);
    const int low = hex_digit(target[i + 2]);
    if (high < 0 || low < 0) return false;
    path.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  return plain_segments(path);
}

std::string_view target_of(std::string_view request) noexcept {
  const std::size_t begin = request.find(' ');
  const std::size_t end = begin == std::string_view::npos ? begin : request.find(' ', begin + 1);
  return end == std::string_view::npos ? std::string_view() : request.substr(begin + 1, end - begin - 1);
}

std::string query_value(std::string_view target, std::string_view key) {
  std::size_t at = target.find('?');
  while (at != std::string_view::npos) {
    const std::size_t begin = at + 1;
    const std::size_t end = std::min(target.find('&', begin), target.size());
    const std::string_view pair = target.substr(begin, end - begin);
    if (pair.size() > key.size() && pair.substr(0, key.size()) == key && pair[key.size()] == '=') {
      return std::string(pair.substr(key.size() + 1));
    }
    at = end < target.size() ? end : std::string_view::npos;
  }
  return {};
}

std::string find_file(const std::vector<WebRoot>& roots, const std::string& path) {
  const WebRoot* best = nullptr;
  for (const WebRoot& root : roots) {
    if (path.compare(0, root.prefix.size(), root.prefix) == 0 &&
        (best == nullptr || root.prefix.size() > best->prefix.size())) {
      best = &root;
    }
  }
  if (best == nullptr) return {};
  std::string rest = path.substr(best->prefix.size());
  if (rest.empty() || rest.back() == '/') rest += "index.html";
  if (rest.front() == '/' || content_type(rest) == nullptr) return {};
  std::error_code error;
  const fs::path folder = fs::canonical(best->folder, error);
  if (error) return {};
  const fs::path file = fs::canonical(folder / rest, error);  // follows links, fails if missing
  if (error || !is_below(file, folder)) return {};
  // A pipe or device would block the thread that opens it.
  if (!fs::is_regular_file(file, error) || error) return {};
  return file.string();
}

const WebDocument* find_document(const std::vector<WebDocument>& documents, std::string_view path) noexcept {
  if (path == "/") path = "/index.html";
  for (const WebDocument& document : documents) {
    if (document.path == path) return &document;
  }
  return nullptr;
}

const char* content_type(std::string_view path) noexcept {
  static constexpr std::array<std::pair<std::string_view, const char*>, 13> kTypes{{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".txt", "text/plain; charset=utf-8"},
      {".urdf", "application/xml"},
      {".dae", "application/xml"},
      {".stl", "model/stl"},
      {".STL", "model/stl"},
      {".obj", "text/plain; charset=utf-8"},
  }};
  for (const auto& [ending, type] : kTypes) {
    if (path.size() > ending.size() && path.substr(path.size() - ending.size()) == ending) {
      return type;
    }
  }
  return nullptr;
}

bool host_allowed(std::string_view host, int port, std::string_view own) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos || host.substr(colon + 1) != std::to_string(port)) {
    return false;
  }
  const std::string_view name = host.substr(0, colon);
  return name == own || (own == "127.0.0.1" && name == "localhost");
}

// No origin at all: not a browser, so no foreign page can be behind it.
bool origin_allowed(std::string_view origin, int port, std::string_view own) {
  constexpr std::string_view kScheme = "http://";
  if (origin.empty()) return true;
  return origin.substr(0, kScheme.size()) == kScheme &&
         host_allowed(origin.substr(kScheme.size()), port, own);
}

bool same_token(std::string_view given, std::string_view expected) noexcept {
  if (expected.empty() || given.size() != expected.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    difference |= static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^
                                        static_cast<unsigned char>(expected[i]));
  }
  return difference == 0;
}

std::string content_policy(const std::string& own, int port, bool near,
                           const std::string& reached_as) {
  const std::string at_port = ":" + std::to_string(port);
  return "default-src 'self'; connect-src 'self' blob: ws://" + own + at_port +
         (near ? " ws://localhost" + at_port : "") +
         (reached_as.empty() ? "" : " ws://" + reached_as) +
         "; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; frame-ancestors 'none'";
}

std::string random_token() {
  std::random_device device;
  std::string token;
  for (int word = 0; word < 4; ++word) {
    std::uint32_t bits = device();
    for (int digit = 0; digit < 8; ++digit, bits >>= 4) token += "0123456789abcdef"[bits & 15u];
  }
  return token;
}

}  // namespace twinbus::viewer_log
