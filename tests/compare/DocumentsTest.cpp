// SPDX-License-Identifier: MIT
// Figures in documents come from a run: scripts/results.py puts them there, and docs/results.json keeps them.
#include "CommandCalls.h"
#include "metrics/Figures.h"

#include <nlohmann/json.hpp>

namespace {

using Shapes::Compare::Tests::CResult;

class DocumentsTest : public Shapes::Compare::Tests::CCommandTest {
protected:
  static CResult Results(const std::string& arguments) {
    return Call(SHAPES_SOURCE_DIR "/scripts/results.py " + arguments, SHAPES_PYTHON);
  }
};

const std::string g_sKept = SHAPES_SOURCE_DIR "/docs/results.json";

TEST_F(DocumentsTest, EveryFigureOfARunIsThatOfTheRunThatIsKept) {
  for (const char* pPage : {"/README.md", "/docs/accuracy.md"}) {
    const std::string page = SHAPES_SOURCE_DIR + std::string(pPage);
    const CResult result = Results("--check " + g_sKept + " " + page);
    EXPECT_EQ(result.m_nExit, 0) << result.m_sOutput;
    // The control: one of them is changed.
    std::string text = Read(page);
    const std::string changed = Write("page.md", text.insert(text.rfind("<!-- end -->"), "1"));
    EXPECT_EQ(Results("--check " + g_sKept + " " + changed).m_nExit, 1);
  }
}

TEST_F(DocumentsTest, EveryFigureHasADefinition) {
  const std::string page = Read(SHAPES_SOURCE_DIR "/docs/accuracy.md");
  for (const Shapes::Compare::CFigure& figure : Shapes::Compare::GetFigures())
    EXPECT_TRUE(Shapes::Says(page, '`' + std::string(figure.m_sKey) + '`'))
        << figure.m_sKey << ": define it in docs/accuracy.md";
  EXPECT_FALSE(Shapes::Says(page, "`no_figure`"));
}

// The script that fills documents, from a run or from what is kept of it, quotes what the tool printed, and
// refuses a run of another version in words.
TEST_F(DocumentsTest, DocumentsAreFilledFromARunOrFromWhatIsKeptOfIt) {
  const CResult printed = Run("run --scenes bowl,corner --contacts 20");
  ASSERT_EQ(printed.m_nExit, 0);
  const std::string run = (m_cFolder / "run.json").string(), kept = (m_cFolder / "kept.json").string();
  ASSERT_EQ(Results("--keep " + run + " " + kept + " " + Write("printed.txt", printed.m_sOutput)).m_nExit, 0);
  EXPECT_LT(std::filesystem::file_size(kept), std::filesystem::file_size(run) / 5);
  const std::string text = "above\n<!-- results: scenes -->\nold\n<!-- end -->\n<!-- results: overall -->\n"
                           "<!-- end -->\n<!-- results: answers -->\n<!-- end -->\n"
                           "<!-- results: ladder bowl 64 angle --><!-- end -->\nbelow\n";
  const std::string page = Write("page.md", text), other = Write("other.md", text);
  EXPECT_EQ(Results(run + " " + page).m_nExit, 0);
  EXPECT_EQ(Results(kept + " " + other).m_nExit, 0);
  const std::string filled = Read("page.md");
  EXPECT_EQ(filled, Read("other.md"));
  EXPECT_TRUE(Shapes::Says(filled, "\n| bowl | "));
  EXPECT_FALSE(Shapes::Says(filled, "old"));
  EXPECT_TRUE(filled.starts_with("above\n") && filled.ends_with("<!-- end -->\nbelow\n")) << filled;

  EXPECT_EQ(
      Results(kept + " " + Write("quote.md", "<!-- results: terminal corner -->\n<!-- end -->\n")).m_nExit,
      0);
  std::istringstream quoted(Read("quote.md"));
  int rows = 0;
  for (std::string row; std::getline(quoted, row);)
    if (row.find("native") != std::string::npos) {
      EXPECT_TRUE(printed.Says(row)) << row;
      ++rows;
    }
  EXPECT_GE(rows, 3); // of the corner, and of each mode over all
  EXPECT_FALSE(Shapes::Says(Read("quote.md"), "bowl"));

  nlohmann::json old = nlohmann::json::parse(Read("run.json"));
  old["version"] = 4;
  Write("run.json", old.dump());
  const CResult refused = Results(run + " " + page);
  EXPECT_EQ(refused.m_nExit, 1);
  EXPECT_TRUE(refused.Says("is of version 4, expected 5"));
  EXPECT_EQ(Read("page.md"), filled);
}

} // namespace
