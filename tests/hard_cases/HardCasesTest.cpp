// SPDX-License-Identifier: MIT
// Every hard case on every engine.
#include "HardCase.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace Shapes::HardCases {
namespace {

class CEveryColumn : public testing::TestWithParam<std::tuple<CHardCase, eColumn>> {};

TEST_P(CEveryColumn, IsWithinItsBoundOrDeviatesAsExpected) {
  const CHardCase& hard = std::get<0>(GetParam());
  const eColumn column = std::get<1>(GetParam());
  const CExpect& expect = hard.m_stdExpect[static_cast<std::size_t>(column)];
  const double bound = column == Reference ? hard.m_cBound.m_fExact : hard.m_cBound.m_fFloat;
  if (expect.m_eKind == CExpect::eKind::Refused) {
    const std::string refusal = MessageOf<std::invalid_argument>([&] { hard.m_fnError(column); });
    EXPECT_NE(refusal, "") << "not refused";
    EXPECT_TRUE(Says(refusal, expect.m_sText));
    return;
  }
  const double error = hard.m_fnError(column);
  if (expect.m_eKind == CExpect::eKind::Right) {
    EXPECT_GE(expect.m_fMost == 0.0 ? bound : expect.m_fMost, bound) << "a wider bound is wider";
    EXPECT_LE(error, expect.m_fMost == 0.0 ? bound : expect.m_fMost)
        << hard.m_cBound.m_sText << "; " << expect.m_sText;
  } else {
    EXPECT_GT(expect.m_fLeast, bound) << "what is within the bound does not deviate";
    EXPECT_GE(error, expect.m_fLeast);
    EXPECT_LE(error, expect.m_fMost);
  }
}

/// Each case with each engine that it applies to.
std::vector<std::tuple<CHardCase, eColumn>> Asked() {
  std::vector<std::tuple<CHardCase, eColumn>> asked;
  for (const CHardCase& hard : AllCases())
    for (std::size_t i = 0; i < g_nColumns; ++i)
      if (hard.m_stdExpect[i].m_eKind != CExpect::eKind::NotAsked)
        asked.emplace_back(hard, static_cast<eColumn>(i));
  return asked;
}

INSTANTIATE_TEST_SUITE_P(HardCases, CEveryColumn, testing::ValuesIn(Asked()), [](const auto& test) {
  return std::get<0>(test.param).m_sName + "_" + GetName(std::get<1>(test.param));
});

class CEveryControl : public testing::TestWithParam<CHardCase> {};

TEST_P(CEveryControl, TheNaiveWayFails) {
  const double error = GetParam().m_fnControl();
  EXPECT_FALSE(error <= std::max(GetParam().m_cBound.m_fExact, GetParam().m_cBound.m_fFloat)) << error;
}

INSTANTIATE_TEST_SUITE_P(HardCases, CEveryControl, testing::ValuesIn(AllCases()),
                         [](const auto& test) { return test.param.m_sName; });

// SHAPES_WRITE_TABLE=1 writes the file instead.
TEST(HardCasesTest, DocumentIsMadeOfTheCases) {
  const std::string path = SHAPES_SOURCE_DIR "/docs/hard_cases.md", table = MakeTable(AllCases());
  if (std::getenv("SHAPES_WRITE_TABLE") != nullptr) {
    std::ofstream(path, std::ios::binary) << table;
    return;
  }
  std::ifstream file(path, std::ios::binary);
  const std::string document{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(document, table) << "run this test with SHAPES_WRITE_TABLE=1 in the environment to write it anew";
}

} // namespace
} // namespace Shapes::HardCases
