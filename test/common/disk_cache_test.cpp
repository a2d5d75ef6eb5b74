#include "common/file/disk_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "common/file/byte_pack.h"
#include "test/temporary_folder.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

const Fingerprint kKey = FingerprintMaker().add("a mesh").value();
const std::string kContent = "what took long to find";

struct DiskCacheTest : testing::Test {
  test::TemporaryFolder folder;
  DiskCache cache{folder.path() + "/below/twinbus"};
  std::vector<std::string> said;

  DiskCacheTest() {
    cache.say = [this](const std::string& line) { said.push_back(line); };
  }
  std::string file() const { return cache.file("kind", kKey); }
  std::string bytes() const {
    std::ifstream in(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& bytes) const {
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << bytes;
  }
};

TEST_F(DiskCacheTest, GivesBackWhatItKeepsAndNothingElse) {
  EXPECT_FALSE(cache.find("kind", kKey));
  cache.keep("kind", kKey, kContent);
  EXPECT_EQ(cache.find("kind", kKey), kContent);
  EXPECT_FALSE(cache.find("other", kKey));
  EXPECT_FALSE(cache.find("kind", FingerprintMaker().add("a mesH").value()));
  EXPECT_TRUE(said.empty());
  struct stat about {};
  ASSERT_EQ(stat(cache.folder().c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777U, 0700U);
}

TEST_F(DiskCacheTest, RefusesEveryFileThatLacksItsEndOrHasAFlippedBitInOneLine) {
  cache.keep("kind", kKey, kContent);
  const std::string whole = bytes();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    put(whole.substr(0, i));
    EXPECT_FALSE(cache.find("kind", kKey)) << "cut at " << i;
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << (i % 8)));
    put(flipped);
    EXPECT_FALSE(cache.find("kind", kKey)) << "flipped at " << i;
    EXPECT_EQ(said.size(), 2 * (i + 1));
    EXPECT_EQ(said.back().find('\n'), std::string::npos);
    EXPECT_FALSE(fs::exists(file()));
  }
  put(whole + "x");
  EXPECT_FALSE(cache.find("kind", kKey));
  cache.keep("kind", kKey, kContent);
  EXPECT_EQ(cache.find("kind", kKey), kContent);
}

TEST_F(DiskCacheTest, RefusesTheFileOfAnotherKeyUnderThisName) {
  const Fingerprint other = FingerprintMaker().add("another").value();
  cache.keep("kind", other, kContent);
  cache.keep("kind", kKey, kContent);
  fs::copy_file(cache.file("kind", other), file(), fs::copy_options::overwrite_existing);
  EXPECT_FALSE(cache.find("kind", kKey));
  EXPECT_EQ(said.size(), 1U);
}

TEST_F(DiskCacheTest, ReadsOnlyPlainFilesThatNobodyElseMayWrite) {
  cache.keep("kind", kKey, kContent);
  ASSERT_EQ(chmod(file().c_str(), 0666), 0);
  EXPECT_FALSE(cache.find("kind", kKey));
  const std::string whole = DiskCache::sealed("kind", kKey, kContent);
  std::ofstream(folder.path() + "/elsewhere", std::ios::binary) << whole;
  fs::create_symlink(folder.path() + "/elsewhere", file());
  EXPECT_FALSE(cache.find("kind", kKey));
  fs::create_directory(file());
  EXPECT_FALSE(cache.find("kind", kKey));
  fs::remove(file());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  EXPECT_FALSE(cache.find("kind", kKey));
  EXPECT_EQ(said.size(), 4U);
}

TEST_F(DiskCacheTest, WithoutAFolderNothingIsKeptAndAFolderThatCannotBeIsSaidOnce) {
  DiskCache off;
  off.keep("kind", kKey, kContent);
  EXPECT_FALSE(off.find("kind", kKey));
  std::ofstream(folder.path() + "/file") << "x";
  DiskCache nowhere(folder.path() + "/file/cache");
  nowhere.say = cache.say;
  for (int i = 0; i < 3; ++i) nowhere.keep("kind", kKey, kContent);
  EXPECT_FALSE(nowhere.find("kind", kKey));
  EXPECT_EQ(said.size(), 1U);
}

TEST_F(DiskCacheTest, IsWholeWhileSeveralWriteAtTheSameTime) {
  cache.keep("kind", kKey, kContent);
  const std::string long_content(100'000, 'y');
  std::vector<std::thread> writers;
  for (int i = 0; i < 4; ++i) {
    writers.emplace_back([&] {
      DiskCache own(cache.folder());
      for (int k = 0; k < 20; ++k) own.keep("kind", kKey, k % 2 == 0 ? long_content : kContent);
    });
  }
  for (int k = 0; k < 100; ++k) {
    const auto found = cache.find("kind", kKey);
    ASSERT_TRUE(found);
    EXPECT_TRUE(*found == kContent || *found == long_content);
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_TRUE(said.empty());
  for (const auto& entry : fs::directory_iterator(cache.folder()))
    EXPECT_EQ(entry.path(), fs::path(file())) << "left behind";
}

TEST(DiskCacheFolder, IsTheOneChosenElseOfXdgElseOfTheHome) {
  EXPECT_EQ(user_cache_folder("/chosen", "/xdg", "/h"), "/chosen");
  EXPECT_EQ(user_cache_folder("off", "/xdg", "/h"), "");
  EXPECT_EQ(user_cache_folder("", "/xdg", "/h"), "/xdg/twinbus");
  EXPECT_EQ(user_cache_folder(nullptr, "not/absolute", "/h"), "/h/.cache/twinbus");
  EXPECT_EQ(user_cache_folder(nullptr, nullptr, nullptr), "");
}

TEST(Unpacker, GivesNothingThatIsNotThere) {
  const std::string bytes = Packer().put(7).put_all(std::vector<double>{1.0, 2.0}).bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Unpacker in(std::string_view(bytes).substr(0, size));
    (void)in.get<int>();
    (void)in.get_all<double>();
    EXPECT_FALSE(in.whole());
  }
  std::string huge = bytes;
  huge[11] = '\x7f';  // of the count
  Unpacker in(huge);
  (void)in.get<int>();
  EXPECT_TRUE(in.get_all<double>().empty());
  EXPECT_TRUE(in.broken());
}

}  // namespace
}  // namespace twinbus
