// SPDX-License-Identifier: MIT
// The page: report.html with its parts and the documents put where it names them as {{name}}, and
// the colours of the engines from their table.
#include "Report.h"

#include "PageTexts.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace Shapes::Compare {
namespace {

std::string_view GetText(std::string_view name) {
  for (const CEmbeddedText& text : g_stdEmbeddedTexts)
    if (text.m_sName == name) return {reinterpret_cast<const char*>(text.m_pBytes), text.m_nSize};
  throw std::logic_error("the page has no part " + std::string(name));
}

// Within a script element "</script" and "<!--" would end or change it. In JSON '<' is only found in strings,
// where it may be written so.
void AppendData(std::string& page, std::string_view json) {
  for (const char c : json)
    if (c == '<')
      page += "\\u003c";
    else
      page += c;
}

} // namespace

std::string MakeHtml(const std::string& run, const std::string& replay, const std::string& charts) {
  std::string page;
  std::string_view rest = GetText("report.html");
  for (;;) {
    const std::size_t begin = rest.find("{{");
    page += rest.substr(0, begin);
    if (begin == std::string_view::npos) return page;
    rest.remove_prefix(begin + 2);
    const std::size_t end = rest.find("}}");
    if (end == std::string_view::npos) throw std::logic_error("the page has a name without an end");
    const std::string_view name = rest.substr(0, end);
    rest.remove_prefix(end + 2);
    if (name == "run")
      AppendData(page, run);
    else if (name == "replay")
      AppendData(page, replay);
    else if (name == "charts")
      AppendData(page, charts);
    else if (name == "light" || name == "dark")
      for (const CEngineRow& row : GetEngineRows())
        page += fmt::format("--{}: {}; ", row.m_sName, name == "light" ? row.m_sColour : row.m_sDark);
    else
      page += GetText(name);
  }
}

} // namespace Shapes::Compare
