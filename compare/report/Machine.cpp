// SPDX-License-Identifier: MIT
#include "Machine.h"

#include <fstream>
#include <thread>

namespace Shapes::Compare {
namespace {

std::string CpuName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0)
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

} // namespace

CMachine DescribeMachine() {
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return {SHAPES_VERSION, SHAPES_BOX2D_VERSION, compiler + ", " SHAPES_BUILD_TYPE, CpuName(),
          std::thread::hardware_concurrency()};
}

} // namespace Shapes::Compare
