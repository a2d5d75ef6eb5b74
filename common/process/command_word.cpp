#include "common/process/command_word.h"

#include <cstdarg>
#include <string_view>
#include <utility>

#include "common/file/beside_program.h"

namespace twinbus {

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
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  std::fputs(as_typed(std::move(text)).c_str(), to);
}

}  // namespace twinbus
