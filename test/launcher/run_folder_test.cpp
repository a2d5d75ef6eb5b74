#include "launcher/stack/run_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "test/temporary_folder.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

const std::string kCommit(40, 'a'), kOther(40, 'b');

class Tree {
 public:
  void put(const std::string& file, const std::string& text) const {
    fs::create_directories((fs::path(folder_.path()) / file).parent_path());
    folder_.write(file, text);
  }
  std::string commit(const std::string& tree = "") const { return commit_of_tree((fs::path(folder_.path()) / tree).string()); }

 private:
  test::TemporaryFolder folder_;
};

TEST(CommitOfTree, IsWhatTheBranchPointsAt) {
  Tree tree;
  EXPECT_EQ(tree.commit(), "unknown");
  tree.put(".git/HEAD", "ref: refs/heads/main\n");
  EXPECT_EQ(tree.commit(), "unknown");
  tree.put(".git/packed-refs", "# pack-refs with: peeled\n" + kOther + " refs/heads/mainly\n" + kCommit + " refs/heads/main\n");
  EXPECT_EQ(tree.commit(), kCommit);
  tree.put(".git/refs/heads/main", kOther + "\n");  // newer than the packed one
  EXPECT_EQ(tree.commit(), kOther);
  tree.put(".git/HEAD", kCommit + "\n");  // no branch
  EXPECT_EQ(tree.commit(), kCommit);
}

TEST(CommitOfTree, IsFoundInAWorktree) {
  Tree tree;
  tree.put("main/.git/refs/heads/side", kCommit + "\n");
  tree.put("main/.git/worktrees/side/HEAD", "ref: refs/heads/side\n");
  tree.put("main/.git/worktrees/side/commondir", "../..\n");
  tree.put("side/.git", "gitdir: ../main/.git/worktrees/side\n");
  EXPECT_EQ(tree.commit("side"), kCommit);
  tree.put("damaged/.git", "nonsense\n");
  EXPECT_EQ(tree.commit("damaged"), "unknown");
}

}  // namespace
}  // namespace twinbus
