#include "launcher/log/foxglove_scene.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>

#include "geometry/mesh/mesh_file.h"
#include "viewer_log/view/frame_number.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kTransformsEvery =
    19'000;  // 50 times a second, of ticks that are no multiple [us]
constexpr std::int64_t kForcesEvery = 32'000;   // [us]
constexpr std::int64_t kTruthFresh = 500'000;   // [us]
constexpr std::size_t kMostTriangles = 30'000;  // of one link; of more the simpler shapes are drawn
constexpr double kMetrePerNewton = 0.001;       // length of the arrows
constexpr double kLeastForce = 5.0;             // [N]

Json stamp(std::int64_t utime) {
  return {{"sec", utime / 1'000'000}, {"nsec", 1000 * (utime % 1'000'000)}};
}

Json xyz(const Vector3d& p) {
  return {{"x", number(p.x(), 5)}, {"y", number(p.y(), 5)}, {"z", number(p.z(), 5)}};
}

Json rotation(const Eigen::Quaterniond& q) {
  return {{"x", number(q.x(), 6)},
          {"y", number(q.y(), 6)},
          {"z", number(q.z(), 6)},
          {"w", number(q.w(), 6)}};
}

Json pose_of(const Eigen::Isometry3d& pose) {
  return {{"position", xyz(pose.translation())},
          {"orientation", rotation(Eigen::Quaterniond(pose.linear()))}};
}

Json colour(double r, double g, double b) {
  return {{"r", r}, {"g", g}, {"b", b}, {"a", 1.0}};
}

Json entity(const std::string& id, const std::string& frame, std::int64_t utime, bool fixed) {
  Json json = {{"timestamp", stamp(utime)},
               {"frame_id", frame},
               {"id", id},
               {"lifetime", {{"sec", 0}, {"nsec", 0}}},
               {"frame_locked", fixed},
               {"metadata", Json::array()}};
  for (const char* kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
    json[kind] = Json::array();
  return json;
}

std::string update(Json entities) {
  return dump({{"deletions", Json::array()}, {"entities", std::move(entities)}});
}

// False for a mesh that is too large or cannot be read.
bool add_mesh(const Shape& shape, const Json& paint, Json& json) {
  TriangleMesh mesh;
  try {
    mesh = load_mesh(shape.mesh, shape.size);
  } catch (const std::exception&) {
    return false;
  }
  if (mesh.triangles.size() > kMostTriangles) return false;
  Json points = Json::array(), indices = Json::array();
  for (const Vector3d& p : mesh.points) points.push_back(xyz(p));
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) indices.push_back(corner);
  }
  json["triangles"].push_back({{"pose", pose_of(shape.pose)},
                               {"points", points},
                               {"color", paint},
                               {"colors", Json::array()},
                               {"indices", indices}});
  return true;
}

bool add_shape(const Shape& shape, const Json& paint, Json& json) {
  if (shape.kind == ShapeKind::kMesh) return add_mesh(shape, paint, json);
  const Vector3d& s = shape.size;
  const Json pose = pose_of(shape.pose);
  if (shape.kind == ShapeKind::kBox) {
    json["cubes"].push_back({{"pose", pose}, {"size", xyz(s)}, {"color", paint}});
  } else if (shape.kind == ShapeKind::kSphere) {
    json["spheres"].push_back(
        {{"pose", pose}, {"size", xyz(Vector3d::Constant(2.0 * s.x()))}, {"color", paint}});
  } else {
    json["cylinders"].push_back({{"pose", pose},
                                 {"size", xyz(Vector3d(2.0 * s.x(), 2.0 * s.x(), s.y()))},
                                 {"bottom_scale", 1},
                                 {"top_scale", 1},
                                 {"color", paint}});
  }
  return true;
}

bool add_shapes(const std::vector<Shape>& shapes, const Json& paint, Json& json) {
  bool all = !shapes.empty();
  for (const Shape& shape : shapes) all = add_shape(shape, paint, json) && all;
  return all;
}

Json object(Json properties) { return {{"type", "object"}, {"properties", std::move(properties)}}; }
Json list(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
Json numbers_of(std::initializer_list<const char*> names) {
  Json properties;
  for (const char* name : names) properties[name] = {{"type", "number"}};
  return object(std::move(properties));
}
Json time_schema(const char* title) {
  Json json = object({{"sec", {{"type", "integer"}}}, {"nsec", {{"type", "integer"}}}});
  json["title"] = title;
  return json;
}

}  // namespace

const std::string& transforms_json_schema() {
  static const std::string text = [] {
    Json schema =
        object({{"transforms", list(object({{"timestamp", time_schema("time")},
                                            {"parent_frame_id", {{"type", "string"}}},
                                            {"child_frame_id", {{"type", "string"}}},
                                            {"translation", numbers_of({"x", "y", "z"})},
                                            {"rotation", numbers_of({"x", "y", "z", "w"})}}))}});
    schema["title"] = kTransformsSchema;
    return schema.dump();
  }();
  return text;
}

const std::string& scene_json_schema() {
  static const std::string text = [] {
    const Json vector = numbers_of({"x", "y", "z"}), paint = numbers_of({"r", "g", "b", "a"});
    const Json pose =
        object({{"position", vector}, {"orientation", numbers_of({"x", "y", "z", "w"})}});
    const Json sized = object({{"pose", pose}, {"size", vector}, {"color", paint}});
    const Json any = object(Json::object());
    Json cylinder = sized;
    cylinder["properties"]["bottom_scale"] =
        cylinder["properties"]["top_scale"] = {{"type", "number"}};
    Json arrow = object({{"pose", pose}, {"color", paint}});
    for (const char* name : {"shaft_length", "shaft_diameter", "head_length", "head_diameter"})
      arrow["properties"][name] = {{"type", "number"}};
    const Json triangles = object({{"pose", pose},
                                   {"points", list(vector)},
                                   {"color", paint},
                                   {"colors", list(paint)},
                                   {"indices", list({{"type", "integer"}})}});
    Json schema = object({{"deletions", list(any)},
                          {"entities", list(object({{"timestamp", time_schema("time")},
                                                    {"frame_id", {{"type", "string"}}},
                                                    {"id", {{"type", "string"}}},
                                                    {"lifetime", time_schema("duration")},
                                                    {"frame_locked", {{"type", "boolean"}}},
                                                    {"metadata", list(any)},
                                                    {"arrows", list(arrow)},
                                                    {"cubes", list(sized)},
                                                    {"spheres", list(sized)},
                                                    {"cylinders", list(cylinder)},
                                                    {"lines", list(any)},
                                                    {"triangles", list(triangles)},
                                                    {"texts", list(any)},
                                                    {"models", list(any)}}))}});
    schema["title"] = kSceneSchema;
    return schema.dump();
  }();
  return text;
}

FoxgloveScene::FoxgloveScene(const Model& model)
    : model_(&model), kinematics_(model), configuration_(model) {
  Json entities = Json::array();
  const Json paint = colour(0.78, 0.81, 0.85);
  for (const Link& link : model.links) {
    Json json = entity(link.name, link.name, 0, true);
    if (!add_shapes(link.visual, paint, json)) {
      json = entity(link.name, link.name, 0, true);
      add_shapes(link.collision, paint, json);
    }
    entities.push_back(std::move(json));
  }
  links_ = entities.dump();
}

void FoxgloveScene::on_truth(const SimTruth& truth, std::int64_t utime) {
  const auto& q = truth.base_attitude;
  const Eigen::Quaterniond attitude(q[0], q[1], q[2], q[3]);
  if (!(attitude.norm() > 0.5)) return;
  configuration_.base.linear() = attitude.normalized().toRotationMatrix();
  configuration_.base.translation() = vector(truth.base_position);
  truth_utime_ = utime;
  has_base_ = true;
}

void FoxgloveScene::on_status(const ControllerStatus& status, std::int64_t utime) {
  if (truth_utime_ != 0 && utime - truth_utime_ < kTruthFresh) return;
  const auto& q = status.base_attitude;
  const Eigen::Quaterniond attitude(static_cast<double>(q[0]), static_cast<double>(q[1]),
                                    static_cast<double>(q[2]), static_cast<double>(q[3]));
  if (!(attitude.norm() > 0.5)) return;
  configuration_.base.linear() = attitude.normalized().toRotationMatrix();
  configuration_.base.translation() = vector(status.base_position);
  has_base_ = true;
}

std::optional<std::string> FoxgloveScene::transforms(const RobotState& state, std::int64_t utime) {
  if (!has_base_ || state.model_hash != model_->hash) return {};
  if (transforms_utime_ != 0 && utime >= transforms_utime_ &&
      utime - transforms_utime_ < kTransformsEvery)
    return {};
  transforms_utime_ = utime;
  set_joints(*model_, state, configuration_);
  kinematics_.update(configuration_);
  Json list = Json::array();
  for (int link = 0; link < model_->link_count(); ++link) {
    const Eigen::Isometry3d& pose = kinematics_.link_in_world(link);
    list.push_back({{"timestamp", stamp(utime)},
                    {"parent_frame_id", "world"},
                    {"child_frame_id", model_->links[static_cast<std::size_t>(link)].name},
                    {"translation", xyz(pose.translation())},
                    {"rotation", rotation(Eigen::Quaterniond(pose.linear()))}});
  }
  return dump({{"transforms", std::move(list)}});
}

std::string FoxgloveScene::robot(std::int64_t utime) const {
  Json entities = Json::parse(links_);
  for (Json& json : entities) json["timestamp"] = stamp(utime);
  return update(std::move(entities));
}

std::optional<std::string> FoxgloveScene::forces(const SimTruth& truth, std::int64_t utime) {
  if (forces_utime_ != 0 && utime >= forces_utime_ && utime - forces_utime_ < kForcesEvery)
    return {};
  forces_utime_ = utime;
  Json json = entity("forces", "world", utime, false);
  const auto add = [&](const Vector3d& at, const Vector3d& force, const Json& paint) {
    const double size = force.norm();
    if (!(size > kLeastForce) || !std::isfinite(size)) return;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = at;
    pose.linear() =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), force / size).toRotationMatrix();
    const double length = kMetrePerNewton * size;
    json["arrows"].push_back({{"pose", pose_of(pose)},
                              {"shaft_length", number(0.8 * length)},
                              {"shaft_diameter", 0.012},
                              {"head_length", number(0.2 * length)},
                              {"head_diameter", 0.025},
                              {"color", paint}});
  };
  const auto rows = static_cast<std::size_t>(std::clamp<int>(truth.contact_count, 0, 8));
  for (std::size_t i = 0; i < rows; ++i)
    add(vector(truth.contact_point[i]), vector(truth.contact_force[i]), colour(0.24, 0.81, 0.56));
  add(vector(truth.push_point), vector(truth.push_force), colour(1.0, 0.35, 0.35));
  return update(Json::array({std::move(json)}));
}

std::string FoxgloveScene::obstacles(const ObstaclesPiece& piece, const std::string& name,
                                     std::int64_t utime) {
  Json json = entity(name + " " + std::to_string(piece.piece), "world", utime, false);
  for (std::size_t i = 0;
       i < static_cast<std::size_t>(std::clamp<int>(piece.count, 0, kObstaclesPerPiece)); ++i) {
    const auto& q = piece.attitude[i];
    Eigen::Quaterniond attitude(static_cast<double>(q[0]), static_cast<double>(q[1]),
                                static_cast<double>(q[2]), static_cast<double>(q[3]));
    if (!(attitude.norm() > 0.5)) continue;
    Shape shape;
    shape.kind = piece.shape[i] == ObstacleShape::kBox      ? ShapeKind::kBox
                 : piece.shape[i] == ObstacleShape::kSphere ? ShapeKind::kSphere
                                                            : ShapeKind::kCylinder;
    shape.size = vector(piece.size[i]);
    shape.pose.linear() = attitude.normalized().toRotationMatrix();
    shape.pose.translation() = vector(piece.position[i]);
    add_shape(shape, colour(0.55, 0.5, 0.42), json);
  }
  return update(Json::array({std::move(json)}));
}

}  // namespace twinbus::launcher
