// SPDX-License-Identifier: MIT
// A folder for each test, because tests may run at the same time; and programs called as a user calls them.
#pragma once

#include "Testing.h"
#include "app/Child.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace Shapes::Compare::Tests {

class CFolderTest : public testing::Test {
protected:
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

private:
  CTemporaryFolder m_cTemporary;

protected:
  const std::filesystem::path& m_cFolder = m_cTemporary.GetPath();
};

/// A PATH for as long as this is.
class CPathVariable {
public:
  explicit CPathVariable(const std::string& path) : m_sOld(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~CPathVariable() { setenv("PATH", m_sOld.c_str(), 1); }
  CPathVariable(const CPathVariable&) = delete;
  CPathVariable& operator=(const CPathVariable&) = delete;

private:
  std::string m_sOld;
};

struct CResult {
  int m_nExit;
  std::string m_sOutput; // both streams

  testing::AssertionResult Says(const std::string& text) const { return Shapes::Says(m_sOutput, text); }
};

class CCommandTest : public CFolderTest {
protected:
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
};

} // namespace Shapes::Compare::Tests
