#include "launcher/operate/package_list.h"

#include <gtest/gtest.h>

#include <sstream>

namespace twinbus {
namespace {

using Names = std::vector<std::string>;

TEST(PackageList, APackageIsForTheReleasesThatItNames) {
  const char* const text = "# a [debian] of words\ng++   compiler [not a place]\nnano [debian-13]  only there\nboth [debian ubuntu-24.04]  x\n"
                           "old [!ubuntu-22.04]  y\nspy: jre  z\ntest?: big [debian]  w\n\nclang\n";
  const auto of = [&](const Names& here) {
    std::istringstream list(text);
    return packages_for(list, here);
  };
  EXPECT_EQ(of({"debian", "debian-12"}).needed, (Names{"g++", "both", "old", "clang"}));
  EXPECT_EQ(of({"debian", "debian-13"}).needed, (Names{"g++", "nano", "both", "old", "clang"}));
  EXPECT_EQ(of({"ubuntu", "ubuntu-22.04"}).needed, (Names{"g++", "clang"}));
  EXPECT_EQ(of({"debian", "debian-12"}).spy, (Names{"jre"}));
}

TEST(PackageList, AReleaseIsNamedByItsFile) {
  std::istringstream file("PRETTY_NAME=\"x\"\nVERSION_ID=\"12\"\nID=debian\n");
  EXPECT_EQ(release_names(file), (Names{"debian", "debian-12"}));
}

}  // namespace
}  // namespace twinbus
