#include "common/file/write_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "test/error_of.h"
#include "test/temporary_folder.h"

namespace twinbus::test {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(WriteFile, WholeIsTheOldTextOrTheNewOne) {
  const TemporaryFolder folder;
  const std::string file = folder.write("wish", "old");
  std::ifstream reader(file);  // has the file open while it is replaced
  write_whole(file, "something new");
  std::string seen;
  std::getline(reader, seen);
  EXPECT_EQ(seen, "old");
  EXPECT_EQ(text_of(file), "something new");
  EXPECT_FALSE(std::filesystem::exists(file + ".new"));
}

TEST(WriteFile, NewMakesItsFolderAndSparesWhatIsThere) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/deep/er/robot.yaml";
  write_new(file, "one");
  EXPECT_NE(error_of([&] { write_new(file, "two"); }).find("exists"), std::string::npos);
  EXPECT_EQ(text_of(file), "one");
  write_file(file, "two");
  EXPECT_EQ(text_of(file), "two");
}

TEST(WriteFile, WhatCannotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  for (const auto write : {write_file, write_whole})
    EXPECT_NE(error_of([&] { write(folder.path() + "/nowhere/x", ""); }).find("nowhere/x"), std::string::npos);
  const std::string taken = folder.path() + "/taken";
  std::filesystem::create_directories(taken + "/full");
  EXPECT_NE(error_of([&] { write_whole(taken, ""); }).find("cannot write " + taken), std::string::npos);
  EXPECT_NE(write_unasked(folder.path() + "/nowhere/x", "").find("nowhere/x"), std::string::npos);
  EXPECT_EQ(write_unasked(folder.path() + "/here", "text"), "");
  EXPECT_EQ(text_of(folder.path() + "/here"), "text");
}

}  // namespace
}  // namespace twinbus::test
