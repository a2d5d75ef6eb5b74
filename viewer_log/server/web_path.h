// From the target of an HTTP request to a file that may be served, or to nothing.
//
// Only regular files below a named root leave the machine's disk: the path is decoded once, has no
// "..", no hidden names and no control characters, its type is known, and symbolic links may not
// lead out of the root.

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace twinbus::inline viewer_log {

struct WebRoot {
  std::string prefix;  // begins and ends with '/'
  std::string folder;
};

struct WebDocument {  // served from memory
  std::string path;   // "/robot.urdf"; that of "/" is "/index.html"
  std::string type;
  std::string body;
  bool of_page = false;  // the same for everybody, given without a token
};

// "/a%20b?x=1" -> "/a b".  False for anything that is not a plain absolute path.
[[nodiscard]] bool decode_target(std::string_view target, std::string& path);

// That of "GET TARGET HTTP/1.1"; empty when it is not whole yet.
std::string_view target_of(std::string_view request) noexcept;

// Value of one key of the query, not decoded (tokens are hexadecimal); empty when absent.
std::string query_value(std::string_view target, std::string_view key);

// The file behind a decoded path (the longest matching prefix wins, "/" of a root is its
// index.html), as an absolute name, or empty when there is none that may be served.
std::string find_file(const std::vector<WebRoot>& roots, const std::string& path);

// The document of a decoded path; nullptr when there is none.
const WebDocument* find_document(const std::vector<WebDocument>& documents, std::string_view path) noexcept;

// MIME type by extension; nullptr for types that are not served.
const char* content_type(std::string_view path) noexcept;

// Host headers of this machine and port, and origins of pages that came from them.  own: the
// address that the connection came to, as it is written in an address ("192.168.1.5", "[fe80::1]");
// names are believed on loopback only, where nobody else can point one at us.
[[nodiscard]] bool host_allowed(std::string_view host, int port,
                                std::string_view own = "127.0.0.1");
[[nodiscard]] bool origin_allowed(std::string_view origin, int port,
                                  std::string_view own = "127.0.0.1");

// What a page may load and connect to: its own server, as it was reached, and nothing else.  reached_as: HOST:PORT that a
// proxy gives it, or empty.
std::string content_policy(const std::string& own, int port, bool near,
                           const std::string& reached_as);

// Takes as long for a wrong token as for the right one; an empty expected token matches nothing.
[[nodiscard]] bool same_token(std::string_view given, std::string_view expected) noexcept;

// 128 random bits in hexadecimal.
std::string random_token();

}  // namespace twinbus::viewer_log
