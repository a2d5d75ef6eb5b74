#include "geometry/mesh/mesh_file.h"

#include "common/text/xml.h"
#include "fixtures.h"

namespace twinbus::test {
namespace {

const char* const kObj =
    "mtllib /dev/zero\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl m\nf 1 2 3\nf 1 2 4\n";
const char* const kStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid a\n";

std::string error(const std::string& bytes, const std::string& file) {
  return error_of([&] { parse_mesh(bytes, file, Eigen::Vector3d::Ones()); });
}

TEST(Mesh, StlAndObjAreReadAndScaled) {
  const TriangleMesh obj = parse_mesh(kObj, "x.obj", {1, 2, 3});
  EXPECT_EQ(obj.triangles.size(), 2u);
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : obj.points) high = high.cwiseMax(point);
  EXPECT_EQ(high, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(parse_mesh(kStl, "X.STL", Eigen::Vector3d::Ones()).triangles.size(), 1u);
}

TEST(Mesh, NonsenseIsRefusedInOneLineWithARemedy) {
  for (const auto& [bytes, file] : std::vector<std::pair<std::string, std::string>>{
           {"", "x.stl"},
           {"hello", "x.stl"},
           {std::string(84, '\xff'), "x.stl"},  // 4 billion triangles in 84 bytes
           {"v 1 2 3\n", "x.obj"},
           {"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "x.obj"},
           {"v 0 0 0\nf 1 2 3\n", "x.obj"},
           {"<COLLADA>", "x.dae"},
           {"<COLLADA/>", "x.dae"},
           {kObj, "x.blend"},
           {kObj, "x"}}) {
    const std::string said = error(bytes, file);
    EXPECT_NE(said.find("mesh " + file + ":"), std::string::npos) << said;
    EXPECT_NE(said.find("; "), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_NE(error(deep, "x.dae").find("nested deeper"), std::string::npos);
  EXPECT_NE(
      error_of([] { load_mesh("/nonexistent/x.stl", Eigen::Vector3d::Ones()); }).find("file name"),
      std::string::npos);
}

TEST(Mesh, EveryMeshOfTheSharedRobotsIsRead) {
  if (data_folder().empty()) GTEST_SKIP() << "no shared data; set TWINBUS_DATA";
  int count = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(data_folder() + "/robots")) {
    const std::string kind = entry.path().extension();
    if (kind != ".stl" && kind != ".obj" && kind != ".dae" && kind != ".STL") continue;
    EXPECT_EQ(error_of([&] { load_mesh(entry.path(), Eigen::Vector3d::Ones()); }), "");
    ++count;
  }
  EXPECT_GT(count, 60);
}

TEST(Mesh, LongListsOfNumbersKeepTheirNumbersAndTheLinesBehindThem) {
  std::string numbers;
  for (int i = 0; i < 40; ++i) numbers += std::to_string(i) + ".5 -1e-3\n";
  const std::string text = "<a><!-- > " + numbers + " --><b>" + numbers + "</b>\n<c>" + numbers +
                           "<d/>" + numbers + "</c><e n='7'>1 2</e></a>";
  const XmlElement root = parse_xml(text, "file");
  ASSERT_EQ(root.children.size(), 3U);
  const std::string trimmed = numbers.substr(0, numbers.size() - 1);
  EXPECT_EQ(root.children[0].text, trimmed);
  EXPECT_EQ(root.children[1].text, trimmed);
  EXPECT_EQ(root.children[2].text, "1 2");
  EXPECT_EQ(root.children[0].line, 41);  // behind the comment
  EXPECT_EQ(root.children[1].line, 82);
  EXPECT_EQ(root.children[2].line, 162);
  EXPECT_EQ(parse_xml("<a><![CDATA[>" + numbers + "<]]></a>", "file").text, ">" + numbers + "<");
}

}  // namespace
}  // namespace twinbus::test
