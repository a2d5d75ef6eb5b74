// What lies around a URDF that nobody has described yet: packages, an SRDF, meshes by relative names.

#include <algorithm>
#include <filesystem>
#include <set>

#include "robot/onboarding/proposal.h"
#include "common/text/xml.h"

namespace twinbus {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const std::string& file) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(file), error).parent_path();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> find_packages(const std::string& urdf_file) {
  const std::string text = read_text_file(urdf_file);
  const std::string scheme = "package://";
  std::set<std::string> names;
  for (std::size_t i = text.find(scheme); i != std::string::npos; i = text.find(scheme, i + 1)) {
    const std::size_t start = std::min(text.find_first_not_of('/', i + scheme.size()), text.size());
    const std::size_t end = text.find_first_of("/\"'<> \n", start);
    if (end != std::string::npos && end > start && end - start < 200)
      names.insert(text.substr(start, end - start));
    if (names.size() > 100) break;
  }
  std::vector<std::pair<std::string, std::string>> packages;
  std::error_code error;
  const fs::path folder = folder_of(urdf_file);
  for (const std::string& name : names) {
    if (name == ".." || name == ".") continue;
    for (fs::path up = folder; up.has_relative_path(); up = up.parent_path()) {
      if (up.filename() == name || fs::is_directory(up / name, error)) {
        packages.emplace_back(name, (up.filename() == name ? up : up / name).string());
        break;
      }
    }
  }
  return packages;
}

std::string find_srdf(const std::string& urdf_file) {
  const fs::path own = folder_of(urdf_file);
  const std::string name = fs::path(urdf_file).stem().string() + ".srdf";
  std::error_code error;
  std::vector<fs::path> others;
  for (const fs::path& folder : {own, own.parent_path() / "srdf"}) {
    if (fs::is_regular_file(folder / name, error)) return (folder / name).string();
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".srdf") others.push_back(entry.path());
    }
  }
  return others.size() == 1 ? others.front().string() : "";
}

std::string with_packages(const std::string& urdf_text, const std::string& urdf_file,
                          std::vector<std::pair<std::string, std::string>>& packages) {
  const fs::path folder = folder_of(urdf_file);
  std::string name = folder.filename().string();
  const auto bad = [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; };
  std::replace_if(name.begin(), name.end(), bad, '_');
  if (name.empty()) name = "robot";
  while (std::any_of(packages.begin(), packages.end(),
                     [&](const auto& known) { return known.first == name; }))
    name += "_";
  const std::string key = "filename=";
  std::string out;
  std::size_t from = 0;
  for (std::size_t i = urdf_text.find(key); i != std::string::npos;
       i = urdf_text.find(key, i + 1)) {
    const std::size_t start = i + key.size() + 1;  // behind the quote
    if (start >= urdf_text.size()) break;
    const std::size_t end = urdf_text.find(urdf_text[start - 1], start);
    if (end == std::string::npos) break;
    const std::string file = urdf_text.substr(start, end - start);
    const bool mesh = file.find("://") == std::string::npos && !file.empty() && file[0] != '/' &&
                      fs::path(file).has_extension();
    if (!mesh || urdf_text.rfind("<mesh", i) == std::string::npos) continue;
    if (urdf_text.find('>', urdf_text.rfind("<mesh", i)) < i) continue;  // of another element
    out += urdf_text.substr(from, start - from) + "package://" + name + "/";
    from = start;
  }
  if (from > 0) packages.emplace_back(name, folder.string());
  return out + urdf_text.substr(from);
}

}  // namespace twinbus
