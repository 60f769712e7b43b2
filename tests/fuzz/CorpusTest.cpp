// SPDX-License-Identifier: MIT
// The seeds of the fuzzers and everything that they ever found, as tests on every compiler: a file in
// corpus/<target>/ is a test of that target.
#include "Fuzz.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace Shapes::Fuzz {
namespace {

using CTarget = void (*)(std::span<const std::uint8_t>);

class CCorpusFile : public testing::Test {
public:
  CCorpusFile(CTarget target, std::filesystem::path file) : m_pTarget(target), m_cFile(std::move(file)) {}

  void TestBody() override {
    std::ifstream in(m_cFile, std::ios::binary);
    ASSERT_TRUE(in) << m_cFile;
    const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(in)), {});
    try {
      m_pTarget(bytes);
    } catch (const CBroken& broken) {
      ADD_FAILURE() << m_cFile << ": " << broken.what();
    }
  }

private:
  CTarget m_pTarget;
  std::filesystem::path m_cFile;
};

// One test for each file. An empty folder would test nothing.
void Register(const char* pName, CTarget target) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(SHAPES_SOURCE_DIR) /
                                                               "tests/fuzz/corpus" / pName))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw std::runtime_error(std::string("corpus/") + pName + " is empty");
  for (const auto& file : files) {
    std::string name = file.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
    testing::RegisterTest((std::string("Corpus_") + pName).c_str(), name.c_str(), nullptr, nullptr, __FILE__,
                          __LINE__, [=] { return new CCorpusFile(target, file); });
  }
}

// The control: what holds nowhere is told.
TEST(Corpus, WhatIsBrokenIsTold) {
  EXPECT_NO_THROW(Require(true, "one is one"));
  try {
    Require(false, "one is two", 1, 2.5);
    FAIL();
  } catch (const CBroken& broken) {
    EXPECT_STREQ(broken.what(), "one is two 1 2.5");
  }
}

} // namespace
} // namespace Shapes::Fuzz

int main(int argc, char** argv) {
  using namespace Shapes::Fuzz;
  testing::InitGoogleTest(&argc, argv);
  Register("pairs", FuzzPairs);
  Register("scene", FuzzScene);
  Register("world", FuzzWorld);
  return RUN_ALL_TESTS();
}
