#include "robot/mesh_file.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

namespace twinbus {

namespace {

constexpr std::uintmax_t kMaxBytes = 64u << 20;
constexpr std::size_t kMaxTriangles = 2'000'000;

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw std::runtime_error("mesh " + file + ": " + what);
}

void append(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
            const Eigen::Vector3d& scale, const std::string& file, TriangleMesh& out) {
  const aiMatrix4x4 pose = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const int first = static_cast<int>(out.points.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D point = pose * mesh.mVertices[i];
      const Eigen::Vector3d scaled(scale.x() * static_cast<double>(point.x),
                                   scale.y() * static_cast<double>(point.y),
                                   scale.z() * static_cast<double>(point.z));
      if (!scaled.allFinite()) fail(file, "a corner is not a finite number; export the mesh again");
      out.points.push_back(scaled);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines
      out.triangles.push_back({first + static_cast<int>(face.mIndices[0]),
                               first + static_cast<int>(face.mIndices[1]),
                               first + static_cast<int>(face.mIndices[2])});
    }
    if (out.triangles.size() > kMaxTriangles)
      fail(file, "more than 2 million triangles; simplify it");
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    append(scene, *node.mChildren[c], pose, scale, file, out);
}

}  // namespace

TriangleMesh load_mesh(const std::string& file, const Eigen::Vector3d& scale) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (error) fail(file, "cannot be read; check the file name in the URDF");
  if (bytes > kMaxBytes) fail(file, "larger than 64 MB; simplify it");

  Assimp::Importer importer;
  // URDF takes COLLADA numbers as they are written.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mRootNode == nullptr) fail(file, importer.GetErrorString());
  TriangleMesh mesh;
  append(*scene, *scene->mRootNode, aiMatrix4x4(), scale, file, mesh);
  if (mesh.triangles.empty()) fail(file, "has no triangle");
  return mesh;
}

}  // namespace twinbus
