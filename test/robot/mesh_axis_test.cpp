// Robots whose origins were made for COLLADA meshes that a program had turned from Y up to Z up.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "robot/lint/mesh_axis.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

class MeshAxis : public ::testing::Test {
 protected:
  MeshAxis() {
    folder_ = fs::path(::testing::TempDir()) / ("mesh_axis_" + std::to_string(::getpid()));
    fs::create_directories(folder_ / "meshes");
  }
  ~MeshAxis() override { fs::remove_all(folder_); }

  // A rod from the origin to 1 m along y.
  std::string rod(const std::string& up) {
    const std::string file = (folder_ / "meshes" / ("rod_" + up + ".dae")).string();
    std::ofstream(file) << "<COLLADA><asset><up_axis>" << up << "</up_axis></asset><library_geometries><geometry id='g'><mesh>"
                        << "<source id='p'><float_array id='a' count='12'>-0.1 0 -0.1 0.1 0 -0.1 0 0 0.2 0 1 0</float_array>"
                        << "<technique_common><accessor source='#a' count='4' stride='3'/></technique_common></source>"
                        << "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
                        << "<triangles count='4'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2 0 1 3 1 2 3 2 0 3</p></triangles>"
                        << "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id='s'><node>"
                        << "<instance_geometry url='#g'/></node></visual_scene></library_visual_scenes>"
                        << "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
    return file;
  }

  static Model of(const std::string& file, const Eigen::Vector3d& com) {
    Model model;
    model.links.resize(1);
    model.links[0].name = "rod";
    model.links[0].mass = 2.0;
    model.links[0].com = com;
    model.links[0].collision.push_back({ShapeKind::kMesh, Eigen::Vector3d::Ones(), Eigen::Isometry3d::Identity(), file});
    return model;
  }

  fs::path folder_;
};

TEST_F(MeshAxis, MeshesAreTurnedWhenOnlyThenTheCentreOfMassIsInside) {
  const std::string up = rod("Y_UP");
  EXPECT_EQ(meshes_to_turn(of(up, {0, 0, 0.4})), std::vector<std::string>{up});
  EXPECT_TRUE(meshes_to_turn(of(up, {0, 0.4, 0})).empty());          // as it is written
  EXPECT_TRUE(meshes_to_turn(of(up, {0.6, 0, 0})).empty());          // neither way
  EXPECT_TRUE(meshes_to_turn(of(rod("Z_UP"), {0, 0, 0.4})).empty());  // it asks for no turn
  EXPECT_TRUE(meshes_to_turn(of((folder_ / "none.dae").string(), {0, 0, 0.4})).empty());
}

TEST_F(MeshAxis, TheTurnIsWrittenIntoTheOriginsOfTheseMeshesOnly) {
  const std::string text =
      "<robot><link name='a'><collision name='c'><origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/><geometry>"
      "<mesh filename='package://robot/meshes/rod.dae'/></geometry></collision>"
      "<visual><geometry><mesh filename=\"package://robot/meshes/rod.dae\"/></geometry></visual>"
      "<visual><origin xyz=\"1 0 0\"/><geometry><mesh filename='package://robot/meshes/rod.dae'/></geometry></visual>"
      "<visual><geometry><mesh filename='package://robot/meshes/other.dae'/></geometry></visual>"
      "<collision><geometry><box size='1 1 1'/></geometry></collision></link></robot>";
  const std::string turned = with_turned_meshes(text, {"/somewhere/robot/meshes/rod.dae"});
  EXPECT_NE(turned.find("<origin xyz='1 2 3' rpy='1.570796327 0.000000000 1.570796327'/>"), std::string::npos) << turned;
  EXPECT_NE(turned.find("<visual><origin xyz=\"0 0 0\" rpy=\"1.570796327 0.000000000 0.000000000\"/>"), std::string::npos) << turned;
  EXPECT_NE(turned.find("<origin rpy=\"1.570796327 0.000000000 0.000000000\" xyz=\"1 0 0\"/>"), std::string::npos) << turned;
  EXPECT_NE(turned.find("<visual><geometry><mesh filename='package://robot/meshes/other.dae'/>"), std::string::npos) << turned;
  EXPECT_NE(turned.find("<collision><geometry><box"), std::string::npos) << turned;
  EXPECT_EQ(with_turned_meshes(text, {}), text);
  EXPECT_EQ(with_turned_meshes("<visual", {"rod.dae"}), "<visual");
  EXPECT_EQ(with_turned_meshes("<visual><mesh filename='rod.dae", {"rod.dae"}), "<visual><mesh filename='rod.dae");
}

}  // namespace
}  // namespace twinbus
