// SPDX-License-Identifier: MIT
// The text of report.html. What it does in a browser is tested in ReportPageTest.cpp.
#include "report/Report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <string>

namespace Shapes::Compare {
namespace {

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++n;
  return n;
}

/// The content of the element that begins with `open`.
std::string Content(const std::string& page, const std::string& open, const std::string& close) {
  const std::size_t begin = page.find(open);
  if (begin == std::string::npos) return {};
  const std::size_t from = begin + open.size();
  return page.substr(from, page.find(close, from) - from);
}

const std::string g_sRunTag = "<script type=\"application/json\" id=\"run\">",
                  g_sReplayTag = "<script type=\"application/json\" id=\"replay\">",
                  g_sChartsTag = "<script type=\"application/json\" id=\"charts\">";

TEST(HtmlTest, HoldsTheDocumentsWhateverIsInThem) {
  const std::string run = R"({"a": "</script><script>alert(1)</script><!-- {{replay}} & \" \\ ü"})";
  const std::string replay = R"({"b": [1, 2, "<b>"]})";
  const std::string charts = R"({"overall": ["<svg></svg>"]})";
  const std::string page = MakeHtml(run, replay, charts);
  EXPECT_EQ(nlohmann::json::parse(Content(page, g_sRunTag, "</script>")), nlohmann::json::parse(run));
  EXPECT_EQ(nlohmann::json::parse(Content(page, g_sReplayTag, "</script>")), nlohmann::json::parse(replay));
  EXPECT_EQ(nlohmann::json::parse(Content(page, g_sChartsTag, "</script>")), nlohmann::json::parse(charts));
}

TEST(HtmlTest, EveryPartIsThereAndEndsWhereItShould) {
  const std::string page = MakeHtml("{}", "{}", "{}");
  EXPECT_EQ(Count(page, "{{"), 0u);
  EXPECT_EQ(Count(page, "<script"), Count(page, "</script>"));
  EXPECT_EQ(Count(page, "<style>"), 1u);
  EXPECT_EQ(Count(page, "</style>"), 1u);
  EXPECT_NE(page.find("Chart.js v3"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* pOutside : {"src=\"", "url(", "@import", "<link rel=\"stylesheet\""})
    EXPECT_EQ(Count(page, pOutside), 0u) << pOutside;
}

// The colours of the page are those of the table of engines, on white and on black.
TEST(HtmlTest, EveryEngineHasItsColours) {
  const std::string page = MakeHtml("{}", "{}", "{}");
  for (const CEngineRow& row : GetEngineRows())
    for (const char* pColour : {row.m_sColour, row.m_sDark})
      EXPECT_EQ(Count(page, std::string("--") + row.m_sName + ": " + pColour + ";"), 1u) << row.m_sName;
}

TEST(HtmlTest, NothingButTheDocumentsDiffers) {
  EXPECT_EQ(MakeHtml("{}", "[]", "{}"), MakeHtml("{}", "[]", "{}"));
  EXPECT_EQ(MakeHtml("{\"a\":1}", "[]", "{}").size(), MakeHtml("{}", "[]", "{}").size() + 5);
}

} // namespace
} // namespace Shapes::Compare
