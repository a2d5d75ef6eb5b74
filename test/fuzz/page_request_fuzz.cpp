// Whatever text a page sends: it is read or refused with a sentence, and without the token it can only stop.

#include <cmath>
#include <cstdlib>
#include <string>

#include "viewer_log/server/page_request.h"

using namespace twinbus;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const bool trusted = (data[0] & 1) != 0;
  PageRequest request;
  std::string problem;
  if (!read_page_request(text, trusted, request, problem)) {
    if (problem.empty()) std::abort();
    (void)note_frame(problem);
    return 0;
  }
  using What = PageRequest::What;
  if (!trusted && request.what != What::kStop && request.what != What::kHello) std::abort();
  if (!std::isfinite(request.amplitude) || !std::isfinite(request.frequency)) std::abort();
  return 0;
}
