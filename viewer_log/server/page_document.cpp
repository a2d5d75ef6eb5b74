#include "viewer_log/server/page_document.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "common/file/beside_program.h"
#include "common/process/command_word.h"

namespace twinbus::inline viewer_log {

WebDocument page_document(const std::string& folder, bool installed) {
  const std::string file = find_file({{"/", folder}}, "/index.html");
  if (file.empty()) throw std::runtime_error("no index.html in " + folder + "; name the page's folder with --web");
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return {"/index.html", content_type(file), as_typed(text, installed), true};
}

WebDocument page_document(const std::string& folder) { return page_document(folder, program_is_installed()); }

}  // namespace twinbus::viewer_log
