#include "robot/lint/mesh_axis.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "common/math/pose_math.h"
#include "common/text/formatted.h"
#include "common/text/xml.h"
#include "robot/description/link_points.h"

namespace twinbus::inline robot {

namespace {

constexpr double kWellOutside = 0.005;  // of a centre of mass from its geometry, in the mean of the masses [m]
constexpr double kClearly = 0.5;        // turned, at most this share of it
constexpr std::size_t kHead = 4096;     // of a COLLADA file, in which <asset> is

Eigen::Matrix3d z_up() { return rotation_about(Eigen::Vector3d::UnitX(), 0.5 * std::numbers::pi); }

// What cannot be read is not turned; the loader says what is wrong with it.
bool says_y_up(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending != ".dae") return false;
  std::ifstream in(file, std::ios::binary);
  std::string head(kHead, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return head.find("Y_UP") != std::string::npos;
}

// The value of an attribute of the element that begins at `start`: where it is in the text; npos: it is not there.
struct Value {
  std::size_t start = std::string::npos, end = 0;
  bool found() const { return start != std::string::npos; }
};
Value value_of(const std::string& text, std::size_t start, const std::string& key) {
  const std::size_t close = text.find('>', start);
  const auto begins_word = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(text[i - 1])) != 0; };
  std::size_t at = text.find(key, start);
  while (at != std::string::npos && at < close && !begins_word(at)) at = text.find(key, at + 1);
  if (at == std::string::npos || at > close) return {};
  at = text.find_first_of("\"'", at + key.size());
  if (at == std::string::npos || at > close) return {};
  const std::size_t end = text.find(text[at], at + 1);
  return end == std::string::npos ? Value{} : Value{at + 1, end};
}

// Behind the scheme and the package of a file name: what its resolved name ends with.
std::string ending_of(const std::string& name) {
  const std::size_t scheme = name.find("://");
  if (scheme == std::string::npos) return std::filesystem::path(name).lexically_normal().generic_string();
  const std::size_t slash = name.find('/', scheme + 3);
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

bool is_one_of(const std::string& name, const std::vector<std::string>& files) {
  const std::string ending = ending_of(name);
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) {
    return file.size() >= ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0;
  });
}

std::string turned_rpy(const std::string& rpy) {
  double angles[3] = {0.0, 0.0, 0.0};
  if (!rpy.empty() && !parse_numbers(rpy, angles, 3)) return rpy;  // the loader refuses it
  Eigen::Vector3d turned = rpy_from_rotation(rotation_from_rpy(angles[0], angles[1], angles[2]) * z_up());
  turned = (turned.array().abs() < 5e-10).select(0.0, turned);
  return formatted("%.9f %.9f %.9f", turned.x(), turned.y(), turned.z());
}

// One <visual> or <collision> without its end tag.
std::string turned(std::string element) {
  const std::size_t origin = element.find("<origin");
  if (origin == std::string::npos) {
    element.insert(element.find('>') + 1, "<origin xyz=\"0 0 0\" rpy=\"" + turned_rpy("") + "\"/>");
    return element;
  }
  const Value rpy = value_of(element, origin, "rpy");
  const std::size_t length = rpy.end - rpy.start;
  if (rpy.found()) return element.replace(rpy.start, length, turned_rpy(element.substr(rpy.start, length)));
  return element.insert(origin + 7, " rpy=\"" + turned_rpy("") + "\"");
}

}  // namespace

std::vector<std::string> meshes_to_turn(const Model& model) {
  std::map<std::string, bool> y_up;
  double as_written = 0.0, when_turned = 0.0, mass = 0.0;
  for (const Link& link : model.links) {
    std::vector<Eigen::Vector3d> before, after;
    bool any = false;
    for (const Shape& shape : link.collision.empty() ? link.visual : link.collision) {
      const auto found = y_up.find(shape.mesh);
      const bool up = shape.kind == ShapeKind::kMesh &&
                      (found != y_up.end() ? found->second : (y_up[shape.mesh] = says_y_up(shape.mesh)));
      Shape other = shape;
      if (up) other.pose.linear() = shape.pose.linear() * z_up();
      try {
        add_points(shape, before);
        add_points(other, after);
      } catch (const std::runtime_error&) {
        continue;
      }
      any = any || up;
    }
    if (!any || before.empty()) continue;
    mass += link.mass;
    as_written += link.mass * outside_hull(before, link.com);
    when_turned += link.mass * outside_hull(after, link.com);
  }
  if (!(as_written > kWellOutside * mass) || !(when_turned < kClearly * as_written)) return {};
  for (const Link& link : model.links) {  // pictures too
    for (const Shape& shape : link.visual) {
      if (shape.kind == ShapeKind::kMesh && !y_up.contains(shape.mesh)) y_up[shape.mesh] = says_y_up(shape.mesh);
    }
  }
  std::vector<std::string> files;
  for (const auto& [file, up] : y_up) {
    if (up) files.push_back(file);
  }
  return files;
}

std::string with_turned_meshes(const std::string& urdf_text, const std::vector<std::string>& files) {
  std::string out;
  std::size_t from = 0;
  while (from < urdf_text.size()) {
    std::size_t start = std::min(urdf_text.find("<visual", from), urdf_text.find("<collision", from));
    if (start == std::string::npos) break;
    const std::string end_tag = urdf_text.compare(start, 7, "<visual") == 0 ? "</visual" : "</collision";
    const std::size_t end = urdf_text.find(end_tag, start);
    if (end == std::string::npos) break;
    std::string element = urdf_text.substr(start, end - start);
    const std::size_t mesh = element.find("<mesh");
    const Value name = mesh == std::string::npos ? Value{} : value_of(element, mesh, "filename");
    if (name.found() && is_one_of(element.substr(name.start, name.end - name.start), files)) element = turned(element);
    out += urdf_text.substr(from, start - from) + element;
    from = end;
  }
  return out + urdf_text.substr(std::min(from, urdf_text.size()));
}

}  // namespace twinbus::robot
