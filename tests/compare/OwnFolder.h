// SPDX-License-Identifier: MIT
// A folder for each test: tests may run at the same time.
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace Shapes::Compare::Tests {

class CFolderTest : public testing::Test {
protected:
  CFolderTest()
      : m_cFolder(std::filesystem::temp_directory_path() /
                  ("shapes-compare-test-" + std::to_string(getpid()) +
                   testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(m_cFolder);
  }
  ~CFolderTest() override { std::filesystem::remove_all(m_cFolder); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(m_cFolder / name, std::ios::binary) << text;
    return (m_cFolder / name).string();
  }
  /// A path that begins at the root is taken as it is.
  std::string Read(const std::filesystem::path& name) const {
    std::ostringstream text;
    text << std::ifstream(m_cFolder / name, std::ios::binary).rdbuf();
    return text.str();
  }

  std::filesystem::path m_cFolder;
};

} // namespace Shapes::Compare::Tests
