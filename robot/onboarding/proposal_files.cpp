// What lies around a URDF that nobody has described yet: packages, an SRDF, meshes by relative names.

#include <algorithm>
#include <filesystem>
#include <set>

#include "robot/onboarding/proposal.h"
#include "common/text/xml.h"

namespace twinbus::inline robot {

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

using Packages = std::vector<std::pair<std::string, std::string>>;

struct MeshName {
  std::size_t start, end;  // in the text
  fs::path file;           // without needless dots; relative to the URDF's folder, or what follows the scheme
  bool has_scheme;         // package://, file://, or a path from the root
};

std::vector<MeshName> mesh_names(const std::string& text) {
  const std::string key = "filename=";
  std::vector<MeshName> found;
  for (std::size_t i = text.find(key); i != std::string::npos; i = text.find(key, i + 1)) {
    const std::size_t start = i + key.size() + 1;  // behind the quote
    if (start >= text.size()) break;
    const std::size_t end = text.find(text[start - 1], start);
    if (end == std::string::npos) break;
    std::string file = text.substr(start, end - start);
    const std::size_t scheme = file.find("://");
    const bool has_scheme = scheme != std::string::npos || file.rfind('/', 0) == 0;
    if (scheme != std::string::npos) file.erase(0, scheme + 3);
    if (!fs::path(file).has_extension() || text.rfind("<mesh", i) == std::string::npos) continue;
    if (text.find('>', text.rfind("<mesh", i)) < i) continue;  // of another element
    found.push_back({start, end, fs::path(file).lexically_normal(), has_scheme});
  }
  return found;
}

int folders_up(const fs::path& file) {
  return static_cast<int>(std::count(file.begin(), file.end(), fs::path("..")));
}

// A name for this folder that is no other package's.
std::string package_of(const fs::path& folder, Packages& packages) {
  for (const auto& [name, known] : packages) {
    if (known == folder.string()) return name;
  }
  std::string name = folder.filename().string();
  const auto bad = [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; };
  std::replace_if(name.begin(), name.end(), bad, '_');
  if (name.empty()) name = "robot";
  while (std::any_of(packages.begin(), packages.end(), [&](const auto& known) { return known.first == name; })) name += "_";
  packages.emplace_back(name, folder.string());
  return name;
}

// Whether the file of this name is where its scheme says.
bool is_there(const std::string& name, const fs::path& file, const Packages& packages) {
  std::error_code error;
  if (name.rfind("package://", 0) != 0) return false;  // of another machine, and none that may be read
  for (const auto& [known, folder] : packages) {
    if (known == file.begin()->string() && fs::is_regular_file(folder / file.lexically_relative(known), error)) return true;
  }
  return false;
}

// The file beside this one whose name differs in capitals alone; this one when there is none.
fs::path in_capitals(const fs::path& file) {
  const auto small = [](const fs::path& path) {
    std::string name = path.filename().string();
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
  };
  std::error_code error;
  if (fs::exists(file, error)) return file;
  for (fs::directory_iterator next(file.parent_path(), error), end; !error && next != end; next.increment(error)) {
    if (small(next->path()) == small(file)) return next->path();
  }
  return file;
}

// The file of an absolute name, or that ends as this name does, in the URDF's folder or one above it; the longest such end, then
// the nearest folder.  Empty when there is none.
std::pair<fs::path, fs::path> found_by_end(const fs::path& file, const fs::path& own) {
  std::error_code error;
  fs::path near = own;
  for (int up = 0; up <= kMostUp && near.has_relative_path(); ++up, near = near.parent_path()) {
    const fs::path end = file.lexically_relative(near);
    if (!end.empty() && *end.begin() != ".." && fs::is_regular_file(file, error)) return {near, end};
  }
  for (fs::path end = file.relative_path(); !end.empty(); end = end.lexically_relative(*end.begin())) {
    if (*end.begin() == "..") continue;
    fs::path folder = own;
    for (int up = 0; up <= kMostUp && folder.has_relative_path(); ++up, folder = folder.parent_path()) {
      const fs::path found = in_capitals(folder / end);
      if (fs::is_regular_file(found, error)) return {folder, end.parent_path() / found.filename()};
    }
    if (end == end.filename()) break;
  }
  return {};
}

}  // namespace

std::string with_packages(const std::string& urdf_text, const std::string& urdf_file, Packages& packages) {
  const std::vector<MeshName> meshes = mesh_names(urdf_text);
  const fs::path own = folder_of(urdf_file);
  // The folder that holds all with relative names: that of the URDF, or one above it (urdf/ beside meshes/).
  int up = 0;
  for (const MeshName& mesh : meshes) up = std::max(up, mesh.has_scheme ? 0 : folders_up(mesh.file));
  fs::path folder = own, below;
  for (int i = 0; i < std::min(up, kMostUp) && folder.parent_path().has_relative_path(); ++i) {
    below = folder.filename() / below;
    folder = folder.parent_path();
  }
  std::string out;
  std::size_t from = 0;
  for (const MeshName& mesh : meshes) {
    const std::string name = urdf_text.substr(mesh.start, mesh.end - mesh.start);
    std::pair<fs::path, fs::path> file{folder, (below / mesh.file).lexically_normal()};
    if (!mesh.has_scheme) {
      file.second.replace_filename(in_capitals(file.first / file.second).filename());
    } else {
      file = is_there(name, mesh.file, packages) ? std::pair<fs::path, fs::path>() : found_by_end(mesh.file, own);
      if (file.second.empty()) continue;
    }
    out += urdf_text.substr(from, mesh.start - from) + "package://" + package_of(file.first, packages) + "/" +
           file.second.generic_string();
    from = mesh.end;
  }
  return out + urdf_text.substr(from);
}

}  // namespace twinbus::robot
