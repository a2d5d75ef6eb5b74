// DAE (COLLADA): geometries of indexed polygons, placed by a tree of nodes.
//
// The unit of the file is applied, its up axis is not: URDF takes the numbers of the axes as they
// are written.  Skins, curves and lines are no geometry of a robot.

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <map>

#include "geometry/mesh/mesh_file.h"
#include "common/text/xml.h"

namespace twinbus::inline geometry {

namespace {

constexpr int kMaxDepth = 64;       // of nodes
constexpr int kMaxParts = 1 << 14;  // geometries placed, each as often as it is placed

class DaeReader {
 public:
  explicit DaeReader(const std::string& file) : file_(file) {}

  TriangleMesh read(const XmlElement& root) {
    if (root.name != "COLLADA") fail(root, "the root element is not <COLLADA>");
    index(root);
    double unit = 1.0;  // [m]
    if (const XmlElement* asset = root.child("asset")) {
      const XmlElement* element = asset->child("unit");
      const std::string* meter = element == nullptr ? nullptr : element->attribute("meter");
      if (meter != nullptr && (!parse_numbers(*meter, &unit, 1) || !(unit > 0.0))) {
        fail(*element, "unit meter must be a positive number");
      }
    }
    const XmlElement* scene = root.child("scene");
    const XmlElement* instance = scene == nullptr ? nullptr : scene->child("instance_visual_scene");
    if (instance == nullptr) fail(root, "has no scene");
    const XmlElement& visual = named(*instance, "url");
    Eigen::Affine3d pose = Eigen::Affine3d::Identity();
    pose.linear() *= unit;
    for (const XmlElement& node : visual.children) place(node, pose, 0);
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(const XmlElement& element, const std::string& what) const {
    fail_at("mesh " + file_, element.line, what + "; export it again, as triangles");
  }

  void index(const XmlElement& element) {
    if (const std::string* id = element.attribute("id")) by_id_.emplace(*id, &element);
    for (const XmlElement& child : element.children) index(child);
  }

  // The element that an attribute like url="#name" points to.
  const XmlElement& named(const XmlElement& from, const char* key) const {
    const std::string* url = from.attribute(key);
    if (url == nullptr || url->empty() || url->front() != '#') {
      fail(from, "<" + from.name + "> needs " + key + "=\"#...\"");
    }
    const auto found = by_id_.find(url->substr(1));
    if (found == by_id_.end()) fail(from, "there is no element " + *url);
    return *found->second;
  }

  template <class Number>
  std::vector<Number> numbers(const XmlElement& element) const {
    std::vector<Number> values;
    const char* at = element.text.data();
    const char* const end = at + element.text.size();
    while (true) {
      while (at < end && static_cast<unsigned char>(*at) <= ' ') ++at;
      if (at == end) return values;
      Number value{};
      const auto [next, error] = std::from_chars(at, end, value);
      if (error != std::errc() || (next<end&& static_cast<unsigned char>(*next)> ' ')) {
        fail(element, "<" + element.name + "> has something that is not a number");
      }
      values.push_back(value);
      at = next;
    }
  }

  void place(const XmlElement& node, const Eigen::Affine3d& parent, int depth) {
    if (node.name != "node") return;
    if (depth > kMaxDepth) fail(node, "nodes nested deeper than 64");
    Eigen::Affine3d pose = parent;
    for (const XmlElement& part : node.children) {
      if (part.name == "matrix") {
        const std::vector<double> m = values(part, 16);
        Eigen::Affine3d step = Eigen::Affine3d::Identity();
        step.matrix().topRows<3>() =
            Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(m.data());
        pose = pose * step;
      } else if (part.name == "translate") {
        const std::vector<double> v = values(part, 3);
        pose.translate(Eigen::Vector3d(v[0], v[1], v[2]));
      } else if (part.name == "scale") {
        const std::vector<double> v = values(part, 3);
        pose.scale(Eigen::Vector3d(v[0], v[1], v[2]));
      } else if (part.name == "rotate") {
        const std::vector<double> v = values(part, 4);  // axis, angle [deg]
        const Eigen::Vector3d axis(v[0], v[1], v[2]);
        if (axis.norm() > 0.0) {
          pose.rotate(
              Eigen::AngleAxisd(v[3] * (3.14159265358979323846 / 180.0), axis.normalized()));
        }
      } else if (part.name == "lookat" || part.name == "skew") {
        fail(part, "<" + part.name + "> is not understood");
      } else if (part.name == "instance_geometry") {
        const XmlElement& geometry = named(part, "url");
        if (const XmlElement* mesh = geometry.child("mesh")) append(*mesh, pose);
      } else if (part.name == "instance_node") {
        place(named(part, "url"), pose, depth + 1);
      } else {
        place(part, pose, depth + 1);
      }
      if (++parts_ > kMaxParts) fail(node, "more than 16384 parts");
    }
  }

  std::vector<double> values(const XmlElement& element, std::size_t count) const {
    std::vector<double> v = numbers<double>(element);
    if (v.size() != count) fail(element, "<" + element.name + "> has the wrong count of numbers");
    return v;
  }

  // Puts the points of a <source> behind those of out_; returns how many.
  int append_points(const XmlElement& source, const Eigen::Affine3d& pose) {
    const XmlElement* array = source.child("float_array");
    const XmlElement* technique = source.child("technique_common");
    const XmlElement* accessor = technique == nullptr ? nullptr : technique->child("accessor");
    if (array == nullptr || accessor == nullptr) fail(source, "positions are not an array");
    double stride = 3.0;
    if (const std::string* text = accessor->attribute("stride");
        text != nullptr &&
        (!parse_numbers(*text, &stride, 1) || !(stride >= 3.0 && stride <= 64.0))) {
      fail(*accessor, "stride must be 3 or more");
    }
    const std::vector<double> all = numbers<double>(*array);
    const std::size_t step = static_cast<std::size_t>(stride);
    const std::size_t count = all.size() / step;
    if (out_.points.size() + count > 3 * kMaxMeshTriangles)
      fail(source, "more than 6 million points");
    for (std::size_t i = 0; i < count; ++i) {
      out_.points.push_back(pose *
                            Eigen::Vector3d(all[step * i], all[step * i + 1], all[step * i + 2]));
    }
    return static_cast<int>(count);
  }

  void append(const XmlElement& mesh, const Eigen::Affine3d& pose) {
    for (const XmlElement& part : mesh.children) {
      const bool polygons = part.name == "polygons";
      if (part.name == "tristrips" || part.name == "trifans") {
        fail(part, "<" + part.name + "> is not understood");
      }
      if (part.name != "triangles" && part.name != "polylist" && !polygons) continue;
      std::size_t stride = 1;
      std::size_t offset = 0;
      const XmlElement* vertices = nullptr;
      for (const XmlElement& input : part.children) {
        if (input.name != "input") continue;
        double at = 0.0;
        if (const std::string* text = input.attribute("offset");
            text != nullptr && (!parse_numbers(*text, &at, 1) || !(at >= 0.0 && at < 64.0))) {
          fail(input, "offset must be 0 to 63");
        }
        stride = std::max(stride, static_cast<std::size_t>(at) + 1);
        const std::string* semantic = input.attribute("semantic");
        if (semantic != nullptr && *semantic == "VERTEX") {
          offset = static_cast<std::size_t>(at);
          vertices = &named(input, "source");
        }
      }
      if (vertices == nullptr) fail(part, "has no input VERTEX");
      const XmlElement* source = nullptr;
      for (const XmlElement& input : vertices->children) {
        const std::string* semantic = input.attribute("semantic");
        if (semantic != nullptr && *semantic == "POSITION") source = &named(input, "source");
      }
      if (source == nullptr) fail(*vertices, "has no input POSITION");
      const auto first = static_cast<int>(out_.points.size());
      const int count = append_points(*source, pose);
      faces(part, stride, offset, first, count);
    }
  }

  // <p> lists stride numbers per corner; <vcount> says how many corners each polygon has.
  void faces(const XmlElement& part, std::size_t stride, std::size_t offset, int first, int count) {
    std::vector<int> sizes;
    if (const XmlElement* vcount = part.child("vcount")) sizes = numbers<int>(*vcount);
    std::vector<int> corners;
    for (const XmlElement& list : part.children) {
      if (list.name != "p") continue;
      const std::vector<int> all = numbers<int>(list);
      const std::size_t total = all.size() / stride;
      std::size_t at = 0;
      for (std::size_t face = 0; at < total; ++face) {
        std::size_t size = part.name == "polygons" ? total : 3;
        if (part.name == "polylist") {
          if (face >= sizes.size() || sizes[face] < 0) break;
          size = static_cast<std::size_t>(sizes[face]);
        }
        if (size > total - at) fail(list, "<p> ends within a polygon");
        corners.clear();
        for (std::size_t k = 0; k < size; ++k, ++at) {
          const int corner = all[at * stride + offset];
          if (corner < 0 || corner >= count)
            fail(list, "a polygon names a corner that does not exist");
          corners.push_back(first + corner);
        }
        add_polygon(corners, file_, out_);
      }
    }
  }

  const std::string& file_;
  std::map<std::string, const XmlElement*> by_id_;
  int parts_ = 0;
  TriangleMesh out_;
};

}  // namespace

TriangleMesh parse_dae(const std::string& text, const std::string& file) {
  const XmlElement root = parse_xml(text, "mesh " + file);
  return DaeReader(file).read(root);
}

}  // namespace twinbus::geometry
