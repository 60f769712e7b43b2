// SPDX-License-Identifier: MIT
// Programs called as a user calls them.
#pragma once

#include "Messages.h"
#include "OwnFolder.h"

#include <sys/wait.h>

#include <cstdio>

namespace Shapes::Compare::Tests {

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
