// Reads every robot file that it is told of, one name per line: URDF, or SRDF by the ending.  Answers each with "loaded" or
// "refused " and the sentence.  For mutated_files_test.py.

#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>

#include "robot/description/srdf.h"
#include "robot/description/urdf.h"

int main() {
  using namespace twinbus;
  for (std::string name; std::getline(std::cin, name);) {
    try {
      const std::string text = read_text_file(name);
      if (name.ends_with(".srdf")) {
        (void)parse_srdf(text, name);
      } else {
        (void)parse_urdf(text, name, {.folder = name.substr(0, name.rfind('/')), .packages = {}});
      }
      std::puts("loaded");
    } catch (const std::runtime_error& error) {
      std::printf("refused %s\n", error.what());
    }
  }
  return 0;
}
