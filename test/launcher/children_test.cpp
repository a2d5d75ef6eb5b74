#include "launcher/stack/children.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace twinbus {
namespace {

namespace fs = std::filesystem;

class Children : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/children_testXXXXXX";
    folder_ = mkdtemp(name);
  }
  void TearDown() override { fs::remove_all(folder_); }

  ChildSpec shell(const std::string& script) const {
    return {"child", {"/bin/sh", "-c", script}, folder_ + "/child.log", true, 0.5};
  }

  std::string folder_;
};

TEST_F(Children, TheEndIsNoticedWithItsStatusAndLastLines) {
  Child child(shell("echo one; echo two >&2; exit 3"));
  EXPECT_TRUE(child.wait_for_end(5.0));
  EXPECT_FALSE(child.running());
  EXPECT_EQ(child.how_it_ended(), "exit status 3");
  EXPECT_FALSE(child.ended_well());
  EXPECT_EQ(child.last_lines(1), std::vector<std::string>{"two"});
}

TEST_F(Children, AProgramThatIsNotThereIsAnErrorThatNamesIt) {
  ChildSpec spec = shell("");
  spec.command = {"/no/such/program"};
  try {
    const Child child(spec);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos);
  }
}

TEST_F(Children, OneThatIgnoresSigtermIsKilledWithItsWholeGroup) {
  {
    Child child(shell("trap '' TERM; sh -c 'trap \"\" TERM; echo $$ >" + folder_ +
                      "/grandchild; while :; do sleep 0.1; done' & "
                      "while :; do sleep 0.1; done"));
    for (int i = 0; i < 100 && !fs::exists(folder_ + "/grandchild"); ++i) usleep(20000);
    usleep(50000);
    child.ask_to_stop();
    EXPECT_FALSE(child.wait_for_end(0.3));
    child.kill_group();
    EXPECT_FALSE(child.running());
    EXPECT_NE(child.how_it_ended().find("signal 9"), std::string::npos);
  }
  std::ifstream file(folder_ + "/grandchild");
  pid_t grandchild = 0;
  file >> grandchild;
  ASSERT_GT(grandchild, 0);
  for (int i = 0; i < 50; ++i) {  // dead or a zombie that init has not reaped yet
    std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
    std::string pid, name, state;
    if (!(stat >> pid >> name >> state) || state == "Z" || state == "X") return SUCCEED();
    usleep(20000);
  }
  FAIL() << "the grandchild lives";
}

TEST_F(Children, TheyDieWithALauncherThatIsKilled) {
  const std::string mark = folder_ + "/pid";
  const pid_t launcher = fork();
  if (launcher == 0) {
    Child child(
        shell("echo $$ >" + mark + ".tmp; mv " + mark + ".tmp " + mark + "; exec sleep 100"));
    for (;;) pause();
  }
  for (int i = 0; i < 200 && !fs::exists(mark); ++i) usleep(20000);
  std::ifstream file(mark);
  pid_t pid = 0;
  file >> pid;
  ASSERT_GT(pid, 0);
  kill(launcher, SIGKILL);
  waitpid(launcher, nullptr, 0);
  for (int i = 0; i < 100; ++i) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    if (!(stat >> number >> name >> state) || state == "Z" || state == "X") return SUCCEED();
    usleep(20000);
  }
  FAIL() << "an orphan lives";
}

}  // namespace
}  // namespace twinbus
