#include "viewer_log/server/web_path.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "robot/description/load.h"
#include "test/temporary_folder.h"
#include "viewer_log/server/page_document.h"
#include "viewer_log/server/robot_roots.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

TEST(WebPath, TheTargetOfARequestIsWhatStandsBetweenTwoSpaces) {
  EXPECT_EQ(target_of("GET /ws?token=ab HTTP/1.1\r\nHost: x"), "/ws?token=ab");
  for (const char* request : {"", "GET", "GET ", "GET /ws?token=a"}) EXPECT_EQ(target_of(request), "") << request;
}

TEST(DecodeTarget, AcceptsPlainPathsAndDropsTheQuery) {
  std::string path;
  ASSERT_TRUE(decode_target("/", path));
  EXPECT_EQ(path, "/");
  ASSERT_TRUE(decode_target("/meshes/a%20b.stl?x=../..", path));
  EXPECT_EQ(path, "/meshes/a b.stl");
}

TEST(DecodeTarget, RefusesEveryWayUp) {
  std::string path;
  for (const char* target :
       {"", "x", "/../etc/passwd", "/..", "/a/../b", "/%2e%2e/etc/passwd", "/a/%2E%2E/b",
        "/.git/config", "/a/.hidden", "/a%00.html", "/a%0a", "/a\\..\\b", "/%5c..%5c", "/%", "/%2",
        "/%zz", "http://127.0.0.1/", "/./a", "//..//"}) {
    EXPECT_FALSE(decode_target(target, path)) << target;
  }
  EXPECT_FALSE(decode_target("/" + std::string(2000, 'a'), path));
}

// "%252e" is decoded once, to "%2e", and is then just a strange name.
TEST(DecodeTarget, DecodesOnce) {
  std::string path;
  ASSERT_TRUE(decode_target("/%252e%252e/x", path));
  EXPECT_EQ(path, "/%2e%2e/x");
}

TEST(QueryValue, FindsWholeKeysOnly) {
  EXPECT_EQ(query_value("/ws?token=abc", "token"), "abc");
  EXPECT_EQ(query_value("/ws?a=1&token=abc&b=2", "token"), "abc");
  EXPECT_EQ(query_value("/ws?xtoken=abc", "token"), "");
  EXPECT_EQ(query_value("/ws", "token"), "");
  EXPECT_EQ(query_value("/ws?", "token"), "");
  EXPECT_EQ(query_value("/ws?token", "token"), "");
}

TEST(Host, OnlyThisMachineAndPort) {
  EXPECT_TRUE(host_allowed("127.0.0.1:8040", 8040));
  EXPECT_TRUE(host_allowed("localhost:8040", 8040));
  for (const char* host : {"", "127.0.0.1", "127.0.0.1:8041", "evil.example:8040", "localhost",
                           "127.0.0.1:8040.evil.example", "localhost:8040:8040"}) {
    EXPECT_FALSE(host_allowed(host, 8040)) << host;
  }
  EXPECT_TRUE(origin_allowed("", 8040));
  EXPECT_TRUE(origin_allowed("http://localhost:8040", 8040));
  for (const char* origin : {"null", "http://evil.example", "https://127.0.0.1:8040",
                             "http://127.0.0.1:8040.evil.example", "file://"}) {
    EXPECT_FALSE(origin_allowed(origin, 8040)) << origin;
  }
}

// Names are not believed there: anybody's name server may point one at us.
TEST(Host, OfAnotherAddressIsThatAddress) {
  EXPECT_TRUE(host_allowed("10.0.0.5:8040", 8040, "10.0.0.5"));
  EXPECT_TRUE(host_allowed("[fd00::5]:8040", 8040, "[fd00::5]"));
  EXPECT_TRUE(origin_allowed("http://10.0.0.5:8040", 8040, "10.0.0.5"));
  for (const char* host :
       {"localhost:8040", "127.0.0.1:8040", "10.0.0.6:8040", "evil.example:8040"}) {
    EXPECT_FALSE(host_allowed(host, 8040, "10.0.0.5")) << host;
  }
}

TEST(Token, IsRandomAndComparedWhole) {
  std::set<std::string> tokens;
  for (int i = 0; i < 20; ++i) tokens.insert(random_token());
  EXPECT_EQ(tokens.size(), 20u);
  const std::string token = random_token();
  EXPECT_EQ(token.size(), 32u);
  EXPECT_TRUE(same_token(token, token));
  EXPECT_FALSE(same_token(token.substr(1), token));
  EXPECT_FALSE(same_token("", token));
  EXPECT_FALSE(same_token("", ""));
}

class FindFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "twinbus_web_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    top_ = name;
    fs::create_directories(top_ / "web/sub");
    fs::create_directories(top_ / "robot");
    for (const char* file : {"web/index.html", "web/sub/app.js", "robot/a.stl", "secret.html",
                             "web/passwd", "web/robot.yaml"}) {
      std::ofstream(top_ / file) << file;
    }
    fs::create_symlink(top_ / "secret.html", top_ / "web/link.html");
    fs::create_directory_symlink(top_, top_ / "web/up");
    mkfifo((top_ / "web/pipe.html").c_str(), 0600);
    roots_ = {{"/", (top_ / "web").string()}, {"/robot/", (top_ / "robot").string()}};
  }
  void TearDown() override { fs::remove_all(top_); }
  fs::path top_;
  std::vector<WebRoot> roots_;
};

TEST_F(FindFile, FindsFilesOfEachRoot) {
  EXPECT_EQ(find_file(roots_, "/"), fs::canonical(top_ / "web/index.html"));
  EXPECT_EQ(find_file(roots_, "/sub/app.js"), fs::canonical(top_ / "web/sub/app.js"));
  EXPECT_EQ(find_file(roots_, "/robot/a.stl"), fs::canonical(top_ / "robot/a.stl"));
}

TEST_F(FindFile, FindsNothingElse) {
  for (const char* path :
       {"/missing.html", "/link.html", "/up/secret.html", "/pipe.html", "/passwd", "/robot.yaml",
        "/sub", "/sub/", "/robot/", "//secret.html", "/../secret.html", "/sub/../../secret.html"}) {
    EXPECT_EQ(find_file(roots_, path), "") << path;
  }
  EXPECT_EQ(find_file({}, "/index.html"), "");
  EXPECT_EQ(find_file({{"/", "/no/such/folder"}}, "/index.html"), "");
}

// A robot that somebody proposed has its meshes elsewhere: package://NAME/ is the folder that its robot.yaml names.
TEST(RobotRoots, PackagesOfRobotYamlAndOwnNameAreRead) {
  char name[] = "/tmp/twinbus_roots_XXXXXX";
  ASSERT_NE(mkdtemp(name), nullptr);
  const fs::path top = name;
  fs::create_directories(top / "mine/meshes");
  fs::create_directories(top / "theirs/meshes");
  for (const char* file : {"mine/meshes/a.stl", "theirs/meshes/b.obj", "theirs/secret.yaml"}) std::ofstream(top / file) << file;
  Model model = load_robot("hrp1s");
  model.folder = (top / "mine").string();
  model.packages.emplace_back("theirs", "../theirs");
  const std::vector<WebRoot> roots = robot_roots(model);
  EXPECT_EQ(find_file(roots, "/robot/meshes/a.stl"), fs::canonical(top / "mine/meshes/a.stl"));
  EXPECT_EQ(find_file(roots, "/robot/package/mine/meshes/a.stl"), fs::canonical(top / "mine/meshes/a.stl"));
  EXPECT_EQ(find_file(roots, "/robot/package/theirs/meshes/b.obj"), fs::canonical(top / "theirs/meshes/b.obj"));
  for (const char* path : {"/robot/package/theirs/secret.yaml", "/robot/package/others/meshes/b.obj",
                           "/robot/package/theirs/../mine/meshes/a.stl"})
    EXPECT_EQ(find_file(roots, path), "") << path;
  fs::remove_all(top);
}

TEST(PageDocument, SaysHowTheProgramIsTyped) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)page_document(folder.path()), std::runtime_error);
  const std::string page = "<html data-command=\"./twinbus\">";
  folder.write("index.html", page);
  const WebDocument here = page_document(folder.path(), false), installed = page_document(folder.path(), true);
  EXPECT_EQ(here.body, page);
  EXPECT_EQ(installed.body, "<html data-command=\"twinbus\">");
  EXPECT_EQ(installed.path, "/index.html");
  EXPECT_TRUE(installed.of_page);
  const std::vector<WebDocument> documents = {{"/robot.urdf", "application/xml", "<robot/>"}, installed};
  EXPECT_EQ(find_document(documents, "/"), &documents[1]);
  EXPECT_EQ(find_document(documents, "/index.html"), &documents[1]);
  EXPECT_FALSE(find_document(documents, "/robot.urdf")->of_page);
  EXPECT_EQ(find_document(documents, "/app.js"), nullptr);
}

}  // namespace
}  // namespace twinbus
