#include "launcher/log/log_output.h"

#include <filesystem>
#include <system_error>

#include "viewer_log/log/log_writer.h"

namespace twinbus::inline launcher {

void refuse_same_file(const std::string& in, const std::string& out) {
  std::error_code ignored;
  if (std::filesystem::equivalent(in, out, ignored))
    throw UsageError("log: " + out + " is the log itself; write into another file");
}

std::string log_output(const Arguments& arguments, const std::string& in) {
  const std::string& out = arguments.word(1);
  refuse_same_file(in, out);
  if (!arguments.has("--force")) refuse_if_there(out);
  return out;
}

}  // namespace twinbus::launcher
