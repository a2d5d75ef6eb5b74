#include "robot/mjcf/mjcf_document.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "common/text/xml.h"
#include "robot/mjcf/mjcf_names.h"

namespace twinbus::inline robot {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 100;
constexpr std::size_t kMostBytes = 32u << 20;  // of all files
constexpr std::ptrdiff_t kMostUp = 3;          // folders above the main file's
constexpr std::size_t kMostNotes = 40;

// Puts the files together.  A file is included once, so that includes end.
class Includer {
 public:
  explicit Includer(std::string main_file) : main_(std::move(main_file)) {
    std::error_code error;
    folder_ = fs::absolute(main_, error).parent_path();
    seen_.insert(fs::weakly_canonical(main_, error).string());
  }

  MjcfDocument read(const std::string& text) {
    const XmlElement root = parse_xml(text, main_);
    if (root.name != "mujoco")
      fail_at(main_, root.line, "the root element is <" + root.name + ">, not <mujoco>; this is no MJCF model");
    MjcfDocument document;
    document.root = expand(root, "mujoco", std::make_shared<const std::string>(main_));
    document.folder = folder_.string();
    std::set<std::string> told;
    for (std::string& note : notes_) {
      if (told.size() < kMostNotes && told.insert(note).second) document.notes.push_back(std::move(note));
    }
    return document;
  }

 private:
  // Recursion is as deep as the tags, at most 64 a file, and as the includes, at most kMostFiles.
  MjcfElement expand(const XmlElement& from, const std::string& context,
                     const std::shared_ptr<const std::string>& file) {
    check_mjcf_names(from, context, *file, notes_);
    MjcfElement element;
    element.name = from.name;
    element.place = {file, from.line};
    for (const auto& [name, value] : from.attributes)
      element.attributes.push_back({name, value, element.place});
    append_children(from, context, file, element);
    return element;
  }

  void append_children(const XmlElement& from, const std::string& context,
                       const std::shared_ptr<const std::string>& file, MjcfElement& into) {
    for (const XmlElement& child : from.children) {
      if (child.name == "include") {
        include(child, context, *file, into);
      } else {
        into.children.push_back(expand(child, mjcf_context(context, child.name), file));
      }
    }
  }

  void include(const XmlElement& element, const std::string& context, const std::string& file, MjcfElement& into) {
    const std::string* name = element.attribute("file");
    if (name == nullptr || name->empty()) fail_at(file, element.line, "<include> without file=\"...\"");
    const std::string path = find(*name, file, element.line);
    const std::string brief = name->substr(0, 200);
    std::error_code error;
    if (!seen_.insert(fs::weakly_canonical(path, error).string()).second) {
      fail_at(file, element.line, "include of " + brief + ": the file is included already, or includes itself; MJCF "
                                                          "includes a file once");
    }
    if (seen_.size() > kMostFiles)
      fail_at(file, element.line, "more than " + std::to_string(kMostFiles) + " files are included; put them together");
    std::string text;
    try {
      text = read_text_file(path);
    } catch (const std::runtime_error& problem) {
      fail_at(file, element.line, "include of " + brief + ": " + problem.what());
    }
    bytes_ += text.size();
    if (bytes_ > kMostBytes)
      fail_at(file, element.line, "the included files have more than " + std::to_string(kMostBytes >> 20) + " MiB");
    XmlElement root = parse_xml(text, path);
    root.attributes.clear();  // of <mujocoinclude> or <mujoco>: nothing that counts here
    check_mjcf_names(root, context, path, notes_);
    append_children(root, context, std::make_shared<const std::string>(path), into);
  }

  // Beside the main file, as MuJoCo does, else beside the including one.
  std::string find(const std::string& name, const std::string& including, int line) const {
    const fs::path relative = fs::path(name).lexically_normal();
    const auto up = std::count(relative.begin(), relative.end(), fs::path(".."));
    if (relative.is_absolute() || up > kMostUp) {
      fail_at(including, line, "include of " + name.substr(0, 200) + ": the file must lie beside the model or at most " +
                                   std::to_string(kMostUp) + " folders above it; write a relative name");
    }
    std::error_code error;
    const fs::path beside_main = folder_ / relative;
    if (fs::exists(beside_main, error)) return beside_main.string();
    const fs::path beside = fs::absolute(including, error).parent_path() / relative;
    return fs::exists(beside, error) ? beside.string() : beside_main.string();
  }

  std::string main_;
  fs::path folder_;
  std::set<std::string> seen_;
  std::size_t bytes_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace

bool is_mjcf_name(const std::string& file) {
  const std::string ending = fs::path(file).extension().string();
  return ending == ".xml" || ending == ".mjcf";
}

MjcfDocument read_mjcf_text(const std::string& text, const std::string& file) { return Includer(file).read(text); }

MjcfDocument read_mjcf(const std::string& file) { return read_mjcf_text(read_text_file(file), file); }

}  // namespace twinbus::robot
