// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace Shapes::Compare {

/// Where the figures come from: without it, times mean nothing.
struct CMachine {
  std::string m_sShapes;   ///< version of the library, and commit if the build knew it
  std::string m_sBox2D;    ///< version
  std::string m_sCompiler; ///< name, version and build type
  std::string m_sCpu;      ///< as the system names it
  unsigned m_nCores = 0;
};
CMachine DescribeMachine();

} // namespace Shapes::Compare
