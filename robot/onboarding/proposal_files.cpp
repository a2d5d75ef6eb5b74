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

namespace {

constexpr int kMostUp = 3;  // folders above the URDF's in which its meshes may lie

struct MeshName {
  std::size_t start, end;  // in the text
  fs::path file;           // relative to the URDF's folder, without needless dots
};

// Meshes by names relative to the URDF's folder.
std::vector<MeshName> relative_meshes(const std::string& text) {
  const std::string key = "filename=";
  std::vector<MeshName> found;
  for (std::size_t i = text.find(key); i != std::string::npos; i = text.find(key, i + 1)) {
    const std::size_t start = i + key.size() + 1;  // behind the quote
    if (start >= text.size()) break;
    const std::size_t end = text.find(text[start - 1], start);
    if (end == std::string::npos) break;
    const std::string file = text.substr(start, end - start);
    const bool mesh = file.find("://") == std::string::npos && !file.empty() && file[0] != '/' &&
                      fs::path(file).has_extension();
    if (!mesh || text.rfind("<mesh", i) == std::string::npos) continue;
    if (text.find('>', text.rfind("<mesh", i)) < i) continue;  // of another element
    found.push_back({start, end, fs::path(file).lexically_normal()});
  }
  return found;
}

int folders_up(const fs::path& file) {
  return static_cast<int>(std::count(file.begin(), file.end(), fs::path("..")));
}

}  // namespace

std::string with_packages(const std::string& urdf_text, const std::string& urdf_file,
                          std::vector<std::pair<std::string, std::string>>& packages) {
  const std::vector<MeshName> meshes = relative_meshes(urdf_text);
  if (meshes.empty()) return urdf_text;
  // The folder that holds them all: that of the URDF, or one above it (urdf/ beside meshes/).
  int up = 0;
  for (const MeshName& mesh : meshes) up = std::max(up, folders_up(mesh.file));
  fs::path folder = folder_of(urdf_file), below;
  for (int i = 0; i < std::min(up, kMostUp) && folder.parent_path().has_relative_path(); ++i) {
    below = folder.filename() / below;
    folder = folder.parent_path();
  }
  std::string name = folder.filename().string();
  const auto bad = [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; };
  std::replace_if(name.begin(), name.end(), bad, '_');
  if (name.empty()) name = "robot";
  while (std::any_of(packages.begin(), packages.end(),
                     [&](const auto& known) { return known.first == name; }))
    name += "_";
  std::string out;
  std::size_t from = 0;
  for (const MeshName& mesh : meshes) {
    const std::string file = (below / mesh.file).lexically_normal().generic_string();
    out += urdf_text.substr(from, mesh.start - from) + "package://" + name + "/" + file;
    from = mesh.end;
  }
  packages.emplace_back(name, folder.string());
  return out + urdf_text.substr(from);
}

}  // namespace twinbus
