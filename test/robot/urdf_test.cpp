#include "robot/description/urdf.h"

#include "fixtures.h"

namespace twinbus::test {
namespace {

UrdfTree parse_file(const std::string& path) {
  return parse_urdf(read_text_file(path), path,
                    {.folder = std::filesystem::path(path).parent_path().string(), .packages = {}});
}

// The sum of all <mass value="...">, read without any of the code under test.
double mass_in_text(const std::string& text) {
  double sum = 0.0;
  for (std::size_t at = text.find("<mass"); at != std::string::npos;
       at = text.find("<mass", at + 1)) {
    const std::size_t quote = text.find_first_of("\"'", at);
    if (quote != std::string::npos) sum += std::stod(text.substr(quote + 1, 40));
  }
  return sum;
}

// What the message must name, of every file in test/robot/bad_urdf and in the shared folder of the
// same name.
const std::pair<const char*, std::vector<const char*>> kBad[] = {
    {"zero", {"empty file"}},
    {"notxml", {"XML"}},
    {"trunc", {"XML"}},
    {"empty", {"no link"}},
    {"version2", {"version 9.9"}},
    {"duplink", {"link a", "twice"}},
    {"dupjoint", {"joint j1", "twice"}},
    {"tworoots", {"roots", "a and b"}},
    {"cycle", {"cycle", "a, b"}},
    {"self", {"joint j1", "link a"}},
    {"cycle_with_root", {"a, b", "root r"}},
    {"twoparents", {"link b", "j1 and j2"}},
    {"noparent", {"joint j1", "link zzz"}},
    {"nochild", {"joint q"}},
    {"badtype", {"joint j1", "type wobbly"}},
    {"nolimit", {"joint j1", "limit"}},
    {"nanlimit", {"joint j1", "limit"}},
    {"invlimit", {"joint j1", "lower", "effort", "velocity"}},
    {"nanxyz", {"joint j1", "origin"}},
    {"garbagexyz", {"joint j1", "origin"}},
    {"nanaxis", {"joint j1", "axis"}},
    {"zeroaxis", {"joint j1", "axis"}},
    {"nonunitaxis", {"joint j1", "axis"}},
    {"commadecimal", {"link a", "mass"}},
    {"nanmass", {"link a", "mass"}},
    {"infmass", {"link a", "mass"}},
    {"negmass", {"link a", "mass", "inertia"}},
    {"mimicself", {"joint j1", "mimic"}},
    {"mimicnone", {"joint j1", "mimic"}},
};

void expect_refused_by_name(const std::string& folder) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    files += entry.path().extension() == ".urdf" && entry.path().stem() != "ok" ? 1 : 0;
  }
  EXPECT_EQ(files, std::size(kBad));
  for (const auto& [name, words] : kBad) {
    const std::string error = error_of([&, stem = name] { parse_file(folder + stem + ".urdf"); });
    EXPECT_NE(error, "") << name;
    EXPECT_EQ(error.find('\n'), std::string::npos) << "one line: " << error;
    for (const char* word : words)
      EXPECT_NE(error.find(word), std::string::npos) << name << ": " << error;
    // Every message ends with what to do, after a semicolon.
    EXPECT_NE(error.find("; "), std::string::npos) << "no remedy: " << error;
    EXPECT_EQ(error.find(folder + name + ".urdf"), 0u) << "no file: " << error;
  }
  const UrdfTree tree = parse_file(folder + "ok.urdf");
  EXPECT_EQ(tree.links.size(), 2u);
  EXPECT_EQ(tree.joints.size(), 1u);
}

TEST(Urdf, EveryMalformedFileIsRefusedByName) {
  expect_refused_by_name(TWINBUS_BAD_URDF_FOLDER "/");
}

TEST(Urdf, EverySharedMalformedFileIsRefusedByName) {
  if (data_folder().empty()) GTEST_SKIP() << "no shared data; set TWINBUS_DATA";
  expect_refused_by_name(data_folder() + "/bad_urdf/");
}

TEST(Urdf, LargeMalformedFilesAreRefused) {
  if (data_folder().empty()) GTEST_SKIP() << "no shared data; set TWINBUS_DATA";
  const TemporaryFolder folder;
  const std::string make = "python3 " + data_folder() + "/bad_urdf/make_large.py " + folder.path();
  if (std::system(make.c_str()) != 0) GTEST_SKIP() << "no python3 to make them";
  const auto error = [&](const char* name) {
    return error_of([&] { parse_file(folder.path() + "/" + name); });
  };
  EXPECT_NE(error("nested_tags.urdf").find("nested deeper than 64; flatten"), std::string::npos);
  EXPECT_NE(error("deep_chain.urdf").find("20001 links"), std::string::npos);
}

TEST(Urdf, MacroFilesAreToldHowToExpandThem) {
  const std::string error = error_of([] {
    parse_urdf(R"(<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:property name="pi" value="3"/><link name="a"/></robot>)",
               "r.urdf", {});
  });
  EXPECT_NE(error.find("r.urdf:2: <xacro:property>"), std::string::npos) << error;
  EXPECT_NE(error.find("xacro r.urdf > robot.urdf"), std::string::npos) << error;
  EXPECT_NE(error_of([] {
              parse_urdf("<robot name='r'><link name='${prefix}a'/></robot>", "r.urdf", {});
            }).find("xacro"),
            std::string::npos);
  // What the expansion leaves behind is no macro.
  EXPECT_EQ(error_of([] {
              parse_urdf("<robot name='r' xmlns:xacro='x'><link name='a'/></robot>", "r.urdf", {});
            }),
            "");
}

TEST(Urdf, TransmissionsGiveTheRotorBehindItsGear) {
  const std::string robot = R"(<robot name="r"><link name="a"/><link name="b"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="j"/>
<actuator name="m"><mechanicalReduction>100</mechanicalReduction><drake:rotor_inertia value="2e-4"/></actuator></transmission>)";
  const UrdfTree tree = parse_urdf(robot + "</robot>", "r.urdf", {});
  EXPECT_NEAR(tree.joints[0].rotor_inertia, 2.0, 1e-12);
  EXPECT_TRUE(tree.notes.empty());
  const UrdfTree strange = parse_urdf(
      robot + "<transmission name='u'><joint name='k'/></transmission></robot>", "r.urdf", {});
  ASSERT_EQ(strange.notes.size(), 1u);
  EXPECT_NE(strange.notes[0].find("joint k, which does not move"), std::string::npos);
  const std::string error = error_of([&] {
    parse_urdf(
        robot +
            "<transmission name='u'><joint name='j'/><actuator name='m'>"
            "<mechanicalReduction>ten</mechanicalReduction></actuator></transmission></robot>",
        "r.urdf", {});
  });
  EXPECT_NE(error.find("transmission u: mechanicalReduction \"ten\" must be"), std::string::npos)
      << error;
}

TEST(Urdf, ForeignRobotsAreRead) {
  if (data_folder().empty()) GTEST_SKIP() << "no shared data; set TWINBUS_DATA";
  const std::string folder = data_folder() + "/robots/";
  for (const char* name : {"jvrc1/jvrc1", "panda/panda", "panda/panda_spherized", "bolt/bolt",
                           "simple_humanoid/simple_humanoid"}) {
    UrdfTree tree;
    ASSERT_EQ(error_of([&, stem = name] { tree = parse_file(folder + stem + ".urdf"); }), "")
        << name;
    double mass = 0.0;
    for (const UrdfLink& link : tree.links) {
      mass += link.mass;
      for (const Shape& shape : link.collision) {
        if (shape.kind == ShapeKind::kMesh) {
          EXPECT_TRUE(std::filesystem::exists(shape.mesh)) << shape.mesh;
        }
      }
    }
    EXPECT_NEAR(mass, mass_in_text(read_text_file(folder + name + ".urdf")), 1e-9) << name;
  }
}

TEST(Urdf, DeepNestingIsRefusedBeforeParsing) {
  std::string deep = "<robot name='r'>";
  for (int i = 0; i < 200000; ++i) deep += "<a>";
  const std::string error = error_of([&] { parse_urdf(deep, "deep.urdf", {}); });
  EXPECT_NE(error.find("nested deeper than 64"), std::string::npos) << error;
  // Neither comments nor quotes hide the depth.
  std::string hidden = "<robot name='r'>";
  for (int i = 0; i < 70; ++i) hidden += "<!-- <x> --><a b='>'>";
  EXPECT_NE(error_of([&] { parse_urdf(hidden, "x", {}); }).find("nested"), std::string::npos);
}

TEST(Urdf, LongChainsAreRefused) {
  std::string chain = "<robot name='r'><link name='l0'/>";
  for (int i = 1; i <= 20000; ++i) {
    const std::string n = std::to_string(i);
    chain += "<link name='l" + n + "'/><joint name='j" + n + "' type='fixed'><parent link='l" +
             std::to_string(i - 1) + "'/><child link='l" + n + "'/></joint>";
  }
  const std::string error = error_of([&] { parse_urdf(chain + "</robot>", "chain.urdf", {}); });
  EXPECT_NE(error.find("20001 links"), std::string::npos) << error;
}

TEST(Urdf, ErrorsKnowTheLine) {
  const std::string text =
      "<robot name='r'>\n<link name='a'/>\n<link name='b'/>\n<joint name='j' type='revolute'>\n"
      "<parent link='a'/><child link='c'/></joint></robot>";
  EXPECT_EQ(error_of([&] { parse_urdf(text, "f.urdf", {}); }),
            "f.urdf:5: joint j: child link c does not exist; did you mean a?");
}

// They overflow in what is computed from them, and different robots would look the same.
TEST(Urdf, NumbersThatNoRobotHasAreRefused) {
  const auto error = [](const std::string& inside) {
    return error_of([&] {
      parse_urdf("<robot name='r'><link name='a'>" + inside + "</link></robot>", "f.urdf", {});
    });
  };
  const std::string inertia =
      "<mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";
  EXPECT_EQ(error("<inertial><origin xyz='0 1e308 0'/>" + inertia),
            "f.urdf:1: link a, inertial: origin xyz has 1e+308; at most 1e+03 m are read");
  EXPECT_EQ(error("<inertial><origin xyz='0 0.1 0'/>" + inertia), "");
  EXPECT_NE(
      error("<visual><origin rpy='0 0 1e9'/><geometry><sphere radius='1'/></geometry></visual>")
          .find("at most"),
      std::string::npos);
}

// A sphere without a radius marks a contact point: Atlas and Valkyrie have them under their feet.
TEST(Urdf, ContactPointsAreSmallBalls) {
  const auto read = [](const std::string& radius) {
    return parse_urdf("<robot name='r'><link name='a'><collision><geometry><sphere radius='" + radius +
                          "'/></geometry></collision></link></robot>",
                      "f.urdf", {});
  };
  EXPECT_EQ(read("0.0").links.at(0).collision.at(0).size.x(), 1e-4);
  EXPECT_EQ(read("0.02").links.at(0).collision.at(0).size.x(), 0.02);
  EXPECT_THROW(read("-0.1"), std::runtime_error);
}

TEST(Urdf, FilesOutsideTheRobotsFolderAreRefused) {
  const auto error = [](const std::string& mesh) {
    const std::string text =
        "<robot name='r'><link name='a'><collision><geometry><mesh filename='" + mesh +
        "'/></geometry></collision></link></robot>";
    return error_of([&] { parse_urdf(text, "f.urdf", {.folder = "/tmp/robot", .packages = {}}); });
  };
  EXPECT_NE(error("../../etc/passwd").find("leaves"), std::string::npos);
  EXPECT_NE(error("/etc/passwd").find("leaves"), std::string::npos);
  EXPECT_NE(error("file:///etc/passwd").find("leaves"), std::string::npos);
  EXPECT_NE(error("file:///tmp/robot/../x.stl").find("leaves"), std::string::npos);
  EXPECT_NE(error("http://a/x.stl").find("only package://, file://"), std::string::npos);
  EXPECT_NE(error("package://other/x.stl").find("package other"), std::string::npos);
  EXPECT_NE(error("package://robot/../../etc/passwd").find("leaves"), std::string::npos);
  EXPECT_NE(error("package:///").find("not"), std::string::npos);
  EXPECT_EQ(error("package://robot/meshes/x.stl"), "");
  EXPECT_EQ(error("package://robot//meshes/x.stl"), "");
  EXPECT_EQ(error("file:///tmp/robot/meshes/x.stl"), "");
  EXPECT_EQ(error("/tmp/robot/meshes/x.stl"), "");
  EXPECT_EQ(error("meshes/x.stl"), "");
  EXPECT_NE(error(std::string(5000, 'x')), "") << "longer than a file name can be";
}

TEST(Urdf, ImpossibleInertiaIsRefused) {
  const auto error = [](const std::string& moments) {
    return error_of([&] {
      parse_urdf("<robot name='r'><link name='a'><inertial><mass value='1'/><inertia " + moments +
                     "/></inertial></link></robot>",
                 "f.urdf", {});
    });
  };
  EXPECT_EQ(error("ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'"), "");
  EXPECT_EQ(error("ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='3'"), "") << "left to check";
  EXPECT_NE(error("ixx='1' ixy='2' ixz='0' iyy='1' iyz='0' izz='1'").find("negative"),
            std::string::npos);
  EXPECT_NE(error("ixx='1' ixy='0' ixz='0' iyy='1' iyz='0'").find("no izz"), std::string::npos);
}

// Nobody mends one fault a time.
TEST(Urdf, WhatIsWrongWithSeveralLinksAndJointsIsSaidAtOnce) {
  const auto parse = [](const std::string& middle) {
    return error_of([&] { (void)parse_urdf("<robot name='r'>\n<link name='a'/>\n<link name='b'/>\n" + middle + "</robot>", "r.urdf", {}); });
  };
  const std::string joint = "<joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint>\n";
  const std::string said = parse("<link name='b'/>\n<link name='c'><inertial><mass value='-1'/></inertial></link>\n" + joint);
  for (const char* fault : {"r.urdf:4: link b is there twice", "\n  r.urdf:5: link c: ", "\n  r.urdf:6: joint j: "})
    EXPECT_NE(said.find(fault), std::string::npos) << fault << " in " << said;
  EXPECT_EQ(parse(joint).find('\n'), std::string::npos) << "one fault is one line";
  std::string many;
  for (int i = 0; i < 20; ++i) many += "<link name='b'/>\n";
  const std::string cut = parse(many);
  EXPECT_EQ(std::count(cut.begin(), cut.end(), '\n'), 12) << cut;
  EXPECT_NE(cut.find("and 8 more"), std::string::npos) << cut;
}

TEST(ParseNumbers, TakesNumbersAndNothingElse) {
  double v[3];
  EXPECT_TRUE(parse_numbers(" 1 -2.5e-3\t+3 ", v, 3));
  EXPECT_EQ(v[1], -2.5e-3);
  for (const char* bad : {"", "1", "1 2", "1 2 3 4", "1 2 nan", "1 2 inf", "1,0 2 3", "1 2 3x",
                          "1 2 0x3", "1 2 1e999", "+-1 2 3"}) {
    EXPECT_FALSE(parse_numbers(bad, v, 3)) << bad;
  }
}

}  // namespace
}  // namespace twinbus::test
