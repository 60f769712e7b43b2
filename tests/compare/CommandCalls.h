// SPDX-License-Identifier: MIT
// Programs called as a user calls them, in a folder of their own.
#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace Shapes::Compare::Tests {

struct CResult {
  int m_nExit;
  std::string m_sOutput; // both streams

  testing::AssertionResult Says(const std::string& text) const {
    const bool says = m_sOutput.find(text) != std::string::npos;
    return (says ? testing::AssertionSuccess() : testing::AssertionFailure()) << text << "\nin\n"
                                                                              << m_sOutput;
  }
};

class CCommandTest : public testing::Test {
protected:
  void SetUp() override {
    const auto* pInfo = testing::UnitTest::GetInstance()->current_test_info();
    m_cFolder = std::filesystem::temp_directory_path() /
                ("shapes-compare-test-" + std::to_string(getpid()) + pInfo->name());
    std::filesystem::create_directories(m_cFolder);
  }
  void TearDown() override { std::filesystem::remove_all(m_cFolder); }

  static CResult Call(const std::string& arguments, const std::string& program = SHAPES_COMPARE) {
    FILE* pPipe = popen((program + " " + arguments + " 2>&1").c_str(), "r");
    CResult result{-1, ""};
    if (pPipe == nullptr) return result;
    char buffer[4096];
    while (const std::size_t n = fread(buffer, 1, sizeof buffer, pPipe))
      result.m_sOutput.append(buffer, n);
    const int status = pclose(pPipe);
    if (WIFEXITED(status)) result.m_nExit = WEXITSTATUS(status);
    return result;
  }

  /// The program writes its reports into the folder of the test.
  CResult Run(const std::string& arguments) const { return Call(arguments + " --out " + m_cFolder.string()); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(m_cFolder / name) << text;
    return (m_cFolder / name).string();
  }
  std::string Read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(m_cFolder / name).rdbuf();
    return text.str();
  }

  std::filesystem::path m_cFolder;
};

} // namespace Shapes::Compare::Tests
