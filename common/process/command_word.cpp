#include "common/process/command_word.h"

#include <cstdarg>
#include <string_view>
#include <utility>

#include "common/file/beside_program.h"
#include "common/text/formatted.h"

namespace twinbus::inline common {

std::string as_typed(std::string text, bool installed) {
  constexpr std::string_view kHere = "./twinbus";
  if (!installed) return text;
  std::size_t at = 0;
  while ((at = text.find(kHere, at)) != std::string::npos) {
    const std::size_t end = at + kHere.size();
    const bool whole = (at == 0 || (text[at - 1] != '.' && text[at - 1] != '/')) &&  // of ../twinbus, a/./twinbus
                       (end == text.size() || std::string_view("/_-").find(text[end]) == std::string_view::npos);
    if (whole) text.erase(at, 2);
    at = whole ? end - 2 : end;
  }
  return text;
}

std::string as_typed(std::string text) {
  static const bool installed = program_is_installed();
  return as_typed(std::move(text), installed);
}

void print_typed(std::FILE* to, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::fputs(as_typed(formatted_list(format, arguments)).c_str(), to);
  va_end(arguments);
}

}  // namespace twinbus::common
