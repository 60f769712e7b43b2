// SPDX-License-Identifier: MIT
#include "Chart.h"

#include "Numbers.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {
namespace {

constexpr double g_fAxisLeast = 0.001, g_fAxisMost = 180.0; // of the axis
constexpr double g_fMark = 9.0;                             // half the size of a mark
constexpr double g_fSmall = 12.0, g_fLarge = 14.0;          // letters
// Widths of letters in times of their size, those of a broad font: a narrower one leaves room.
constexpr double g_fLetter = 0.62, g_fBoldLetter = 0.72;

// Pixels of width up to which there is room for short words only.
constexpr double g_fNarrow = 500.0;

struct CBox {
  double m_fLeft, m_fTop, m_fRight, m_fBottom;
  double OverlapWith(const CBox& b) const {
    const double w = std::min(m_fRight, b.m_fRight) - std::max(m_fLeft, b.m_fLeft);
    const double h = std::min(m_fBottom, b.m_fBottom) - std::max(m_fTop, b.m_fTop);
    return w > 0.0 && h > 0.0 ? w * h : 0.0;
  }
};

std::string Escape(const std::string& text) {
  std::string safe;
  for (const char c : text)
    c == '<' ? safe += "&lt;" : c == '&' ? safe += "&amp;" : c == '"' ? safe += "&quot;" : safe += c;
  return safe;
}

double Width(const std::string& text, double size, double letter) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return static_cast<double>(letters) * size * letter;
}

// An axis of powers of ten from first to last, drawn from `from` to `to`.
struct CAxis {
  double m_fFirst, m_fLast, m_fFrom, m_fTo;
  double At(double x) const {
    const double share = std::log(std::clamp(x, m_fFirst, m_fLast) / m_fFirst) / std::log(m_fLast / m_fFirst);
    return m_fFrom + share * (m_fTo - m_fFrom);
  }
};

// The next 1, 2 or 5 of a decade, below or above.
double Nice(double x, bool isBelow) {
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  double below = decade, above = 10.0 * decade;
  for (const double lead : {2.0, 5.0}) {
    if (lead * decade <= x) below = lead * decade;
    if (lead * decade >= x) above = std::min(above, lead * decade);
  }
  return isBelow ? below : x <= decade ? decade : above;
}

class CDrawing {
public:
  CDrawing(const CChart& chart, const CChartSize& size, bool isAlone)
      : m_cChart(chart), m_cSize(size), m_bAlone(isAlone) {
    MakeLegend();
    m_cArea = {74.0, 12.0, size.m_fWidth - 12.0, size.m_fHeight - 46.0 - m_fLegendHeight};
    double first = 1e300, last = 0.0;
    for (const CChartPoint& p : chart.m_stdPoints) {
      first = std::min({first, p.m_fNs, p.m_cNs.m_fLow > 0.0 ? p.m_cNs.m_fLow : p.m_fNs});
      last = std::max({last, p.m_fNs, p.m_cNs.m_fHigh});
    }
    if (chart.m_stdPoints.empty()) first = 10.0, last = 1000.0;
    m_cX = {Nice(first / 1.15, true), Nice(last * 1.15, false), m_cArea.m_fLeft, m_cArea.m_fRight};
    m_cY = {g_fAxisLeast, g_fAxisMost, m_cArea.m_fBottom - 2.0 * g_fMark, m_cArea.m_fTop + g_fMark};
  }

  std::string Draw() {
    m_sSvg =
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                    "height=\"{1}\" role=\"img\" class=\"engines\" font-family=\"system-ui, 'DejaVu Sans', "
                    "sans-serif\"><title>{2}</title>",
                    m_cSize.m_fWidth, m_cSize.m_fHeight, Escape(m_cChart.m_sTitle));
    if (m_bAlone) AddColours();
    AddAxes();
    AddFront();
    for (const CChartPoint& p : m_cChart.m_stdPoints)
      AddBars(p);
    // The first one lies above.
    for (auto p = m_cChart.m_stdPoints.rbegin(); p != m_cChart.m_stdPoints.rend(); ++p)
      AddMark(X(*p), Y(*p), g_fMark, *p->m_pRow, GradeOf(p->m_nLost, p->m_nOf, std::nullopt, std::nullopt));
    for (const CChartPoint& p : m_cChart.m_stdPoints)
      AddLabel(p);
    AddLegend();
    return m_sSvg + "</svg>";
  }

private:
  double X(const CChartPoint& p) const { return m_cX.At(p.m_fNs); }
  double Y(const CChartPoint& p) const { return m_cY.At(p.m_fError / g_fDegree); }

  void AddColours() {
    std::string light = "--bg:#fff;--ink:#1b1f24;--muted:#545d68;--line:#cfd6dd;",
                dark = "--bg:#14171b;--ink:#e8eaed;--muted:#a9b1bb;--line:#3b424a;";
    for (const CEngineRow& row : GetEngineRows()) {
      light += fmt::format("--{}:{};", row.m_sName, row.m_sColour);
      dark += fmt::format("--{}:{};", row.m_sName, row.m_sDark);
    }
    m_sSvg += fmt::format("<style>svg{{{}}}@media(prefers-color-scheme:dark){{svg{{{}}}}}</style>"
                          "<rect width=\"100%\" height=\"100%\" fill=\"var(--bg)\"/>",
                          light, dark);
  }

  void AddText(double x, double y, const std::string& text, const char* pMore = "") {
    m_sSvg +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"var(--muted)\"{}>{}</text>", x,
                    y, g_fSmall, pMore, Escape(text));
  }
  void AddLine(double x0, double y0, double x1, double y1, const std::string& colour,
               const char* pMore = "") {
    m_sSvg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\"{}/>", x0, y0, x1, y1,
                          colour, pMore);
  }

  void AddAxes() {
    const double bottom = m_cArea.m_fBottom, left = m_cArea.m_fLeft, right = m_cArea.m_fRight;
    double taken = -1e300; // the right end of the last name
    const bool isLong = m_cX.m_fLast / m_cX.m_fFirst > 30.0;
    for (double decade = Nice(m_cX.m_fFirst, true) / 10.0; decade <= m_cX.m_fLast; decade *= 10.0)
      for (const double lead : {1.0, 2.0, 5.0}) {
        const double ns = lead * std::pow(10.0, std::round(std::log10(decade)));
        if (ns < 0.999 * m_cX.m_fFirst || ns > 1.001 * m_cX.m_fLast) continue;
        const double x = m_cX.At(ns);
        AddLine(x, m_cArea.m_fTop, x, bottom, "var(--line)");
        const std::string name = CountText(static_cast<std::size_t>(std::lround(ns)));
        const double half = 0.5 * Width(name, g_fSmall, g_fLetter);
        if (x - half < taken + 6.0 || x + half > m_cSize.m_fWidth || (isLong && lead == 2.0)) continue;
        AddText(x, bottom + 16.0, name, " text-anchor=\"middle\"");
        taken = x + half;
      }
    for (const double degrees : {0.001, 0.01, 0.1, 1.0, 10.0, 100.0}) {
      const double y = m_cY.At(degrees);
      AddLine(left, y, right, y, "var(--line)");
      AddText(left - 6.0, y + 4.0,
              degrees == g_fAxisLeast ? "≤ .001°" : fmt::format("{}°", TwoDigits(degrees)),
              " text-anchor=\"end\"");
    }
    AddText(0.5 * (left + right), bottom + 36.0,
            m_cSize.m_fWidth > g_fNarrow ? "nanoseconds for one step of one ball (left is faster)"
                                         : "ns for a step of a ball (left: faster)",
            " text-anchor=\"middle\"");
    const double middle = 0.5 * (m_cArea.m_fTop + bottom);
    AddText(12.0, middle, "error of 95% of the bounces (down: exact)",
            fmt::format(" text-anchor=\"middle\" transform=\"rotate(-90 12 {:.1f})\"", middle).c_str());
  }

  // Steps from point to point of the front: nothing is left of them and below.
  void AddFront() {
    std::vector<const CChartPoint*> front;
    for (const CChartPoint& p : m_cChart.m_stdPoints)
      if (p.m_bFront) front.push_back(&p);
    if (front.empty()) return;
    std::sort(front.begin(), front.end(), [](auto* a, auto* b) { return a->m_fNs < b->m_fNs; });
    double x = X(*front.front()), y = m_cArea.m_fTop;
    std::string path = fmt::format("M{:.1f} {:.1f}", x, y);
    for (const CChartPoint* pPoint : front) {
      path += fmt::format("H{:.1f}V{:.1f}", X(*pPoint), Y(*pPoint));
      m_stdFront.push_back({x, y - 2.0, X(*pPoint), y + 2.0});
      m_stdFront.push_back({X(*pPoint) - 2.0, y, X(*pPoint) + 2.0, Y(*pPoint)});
      x = X(*pPoint), y = Y(*pPoint);
    }
    m_stdFront.push_back({x, y - 2.0, m_cArea.m_fRight, y + 2.0});
    m_sSvg += fmt::format("<path d=\"{}H{:.1f}\" fill=\"none\" stroke=\"var(--muted)\" stroke-width=\"1.5\" "
                          "stroke-dasharray=\"5 4\"/>",
                          path, m_cArea.m_fRight);
  }

  void AddBars(const CChartPoint& p) {
    const std::string colour = fmt::format("var(--{})", p.m_pRow->m_sName);
    const char* pStyle = " stroke-width=\"3\" stroke-opacity=\"0.45\"";
    if (p.m_cNs.m_fHigh > p.m_cNs.m_fLow)
      AddLine(m_cX.At(p.m_cNs.m_fLow), Y(p), m_cX.At(p.m_cNs.m_fHigh), Y(p), colour, pStyle);
    if (p.m_cError.m_fHigh > p.m_cError.m_fLow)
      AddLine(X(p), m_cY.At(p.m_cError.m_fLow / g_fDegree), X(p), m_cY.At(p.m_cError.m_fHigh / g_fDegree),
              colour, pStyle);
  }

  // Full: few are lost. With a dot: some. Hollow: many.
  void AddMark(double x, double y, double r, const CEngineRow& row, eGrade loss) {
    const std::string_view mark = row.m_sMark;
    std::string shape;
    if (mark == "circle")
      shape = fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"", x, y, r);
    else if (mark == "triangle")
      shape = fmt::format("<path d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}z\"", x, y - 1.1 * r, 1.1 * r,
                          2.0 * r, -2.2 * r);
    else if (mark == "rectRot")
      shape = fmt::format("<path d=\"M{0:.1f} {1:.1f}l{2:.1f} {2:.1f}l-{2:.1f} {2:.1f}l-{2:.1f} -{2:.1f}z\"",
                          x, y - 1.2 * r, 1.2 * r);
    else
      shape = fmt::format("<rect x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{2:.1f}\"{3}",
                          x - 0.88 * r, y - 0.88 * r, 1.76 * r, mark == "rectRounded" ? " rx=\"4\"" : "");
    const std::string colour = fmt::format("var(--{})", row.m_sName);
    m_sSvg += fmt::format("{} fill=\"{}\" stroke=\"{}\" stroke-width=\"2.5\" data-engine=\"{}\"/>", shape,
                          loss == eGrade::Good ? colour : "var(--bg)", colour, row.m_sName);
    if (loss == eGrade::Rough)
      m_sSvg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>", x, y, 0.42 * r,
                            colour);
  }

  static CBox MarkBox(double x, double y) {
    constexpr double r = g_fMark + 4.0;
    return {x - r, y - r, x + r, y + r};
  }

  static double GetDistance(const CBox& box, double x, double y) {
    return std::hypot(std::clamp(x, box.m_fLeft, box.m_fRight) - x,
                      std::clamp(y, box.m_fTop, box.m_fBottom) - y);
  }

  // The label goes where it covers least, near its mark; marks and other labels count most.
  void AddLabel(const CChartPoint& p) {
    const std::string lost =
        p.m_nLost == 0 ? "none lost" : fmt::format("loses {}", LossText(p.m_nLost, p.m_nOf));
    const std::string& name = m_cSize.m_fWidth > g_fNarrow ? p.m_pRow->m_sName : p.m_pRow->m_sShort;
    const double width = std::max(Width(name, g_fLarge, g_fBoldLetter), Width(lost, g_fSmall, g_fLetter));
    constexpr double height = 34.0;
    CBox best{};
    double least = 1e300;
    for (double top = m_cArea.m_fTop; top + height <= m_cArea.m_fBottom; top += 4.0)
      for (double left = m_cArea.m_fLeft + 2.0; left + width <= m_cSize.m_fWidth; left += 6.0) {
        const CBox box{left, top, left + width, top + height};
        const double far = GetDistance(box, X(p), Y(p)) - g_fMark;
        const double cost = CostOf(box) + std::abs(far - 5.0) + (left > X(p) ? 0.0 : 3.0);
        if (cost < least) least = cost, best = box;
      }
    m_stdLabels.push_back(best);
    const double x = best.m_fLeft, y = best.m_fTop;
    if (GetDistance(best, X(p), Y(p)) > g_fMark + 14.0)
      AddLine(X(p), Y(p), std::clamp(X(p), best.m_fLeft, best.m_fRight),
              std::clamp(Y(p), best.m_fTop, best.m_fBottom), "var(--muted)");
    m_sSvg += fmt::format(
        "<g class=\"label\" data-of=\"{0}\" paint-order=\"stroke\" stroke=\"var(--bg)\" "
        "stroke-width=\"4\" stroke-linejoin=\"round\"><text x=\"{1:.1f}\" y=\"{2:.1f}\" font-size=\"{3}\" "
        "font-weight=\"600\" fill=\"var(--ink)\">{7}</text><text x=\"{1:.1f}\" y=\"{4:.1f}\" "
        "font-size=\"{5}\" fill=\"var(--ink)\">{6}</text></g>",
        p.m_pRow->m_sName, x, y + 14.0, g_fLarge, y + 29.0, g_fSmall, lost, name);
  }

  double CostOf(const CBox& box) const {
    constexpr double hard = 100.0, soft = 0.1; // for a square pixel
    double cost = 0.0;
    for (const CBox& label : m_stdLabels)
      cost += hard * box.OverlapWith(label);
    for (const CBox& piece : m_stdFront)
      cost += soft * box.OverlapWith(piece);
    for (const CChartPoint& p : m_cChart.m_stdPoints) {
      cost += hard * box.OverlapWith(MarkBox(X(p), Y(p)));
      cost +=
          soft * box.OverlapWith({m_cX.At(p.m_cNs.m_fLow), Y(p) - 2.0, m_cX.At(p.m_cNs.m_fHigh), Y(p) + 2.0});
      cost += soft * box.OverlapWith({X(p) - 2.0, m_cY.At(p.m_cError.m_fHigh / g_fDegree), X(p) + 2.0,
                                      m_cY.At(p.m_cError.m_fLow / g_fDegree)});
    }
    return cost;
  }

  // The legend flows in lines below the axis.
  struct CItem {
    std::string m_sText;
    double m_fLeft, m_fLine;
  };
  void MakeLegend() {
    constexpr double sign = 26.0, gap = 16.0, left = 8.0;
    double x = left, line = 0.0;
    for (const std::string& text :
         {std::string("at most 1 in 1,000 lost"), std::string("at most 1 in 100"), std::string("more lost"),
          std::string("none is faster and more exact"), m_cChart.m_sBars}) {
      const double width = sign + Width(text, g_fSmall, g_fLetter);
      if (x > left && x + width > m_cSize.m_fWidth) x = left, line += 20.0;
      m_stdLegend.push_back({text, x, line});
      x += width + gap;
    }
    m_fLegendHeight = line + 22.0;
  }
  void AddLegend() {
    static const CEngineRow neutral{"ink", "", "", "", "", g_cAutomatic, eProfile::Shipped, "circle", "", ""};
    const double top = m_cSize.m_fHeight - m_fLegendHeight + 12.0;
    constexpr eGrade losses[] = {eGrade::Good, eGrade::Rough, eGrade::Poor};
    for (std::size_t i = 0; i < m_stdLegend.size(); ++i) {
      const CItem& item = m_stdLegend[i];
      const double x = item.m_fLeft, y = top + item.m_fLine;
      if (i < 3)
        AddMark(x + 11.0, y - 4.0, 5.5, neutral, losses[i]);
      else if (i == 3)
        AddLine(x, y - 4.0, x + 22.0, y - 4.0, "var(--muted)",
                " stroke-width=\"1.5\" stroke-dasharray=\"5 4\"");
      else
        AddLine(x, y - 4.0, x + 22.0, y - 4.0, "var(--ink)", " stroke-width=\"3\" stroke-opacity=\"0.45\"");
      AddText(x + 26.0, y, item.m_sText);
    }
  }

  const CChart& m_cChart;
  CChartSize m_cSize;
  bool m_bAlone;
  CBox m_cArea{};
  CAxis m_cX{}, m_cY{};
  double m_fLegendHeight = 0.0;
  std::vector<CItem> m_stdLegend;
  std::vector<CBox> m_stdLabels, m_stdFront;
  std::string m_sSvg;
};

std::string Describe(const CChart& chart, const std::string& what) {
  std::string text = what + ":";
  for (const CChartPoint& p : chart.m_stdPoints)
    text += fmt::format(" {} {:.0f} ns, 95% of bounces within {}, lost {}{}", p.m_pRow->m_sName, p.m_fNs,
                        DegreesText(p.m_fError), LossText(p.m_nLost, p.m_nOf),
                        &p == &chart.m_stdPoints.back() ? "." : ";");
  return text;
}

} // namespace

CChart MakeOverallChart(const CRunReport& report, const COverall& overall) {
  CChart chart{"", "from the best scene to the worst", {}};
  for (std::size_t e = 0; e < overall.m_stdEngines.size(); ++e) {
    const CEngineOverall& engine = overall.m_stdEngines[e];
    if (engine.m_nCompared > 0)
      chart.m_stdPoints.push_back({&GetEngineRow(report.m_stdEngines[e].m_sName), engine.m_cNs.m_fMedian,
                                   engine.m_cNsScenes, engine.m_cDirection.m_fValue,
                                   engine.m_cDirectionScenes, engine.m_nLost, overall.m_nImpacts,
                                   engine.m_bFront});
  }
  chart.m_sTitle = Describe(chart, "Time against error over all scenes");
  return chart;
}

CChart MakeSceneChart(const CRunReport& report, const CSceneReport& scene) {
  CChart chart{"", "interval of the time, median to largest error", {}};
  for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e) {
    const CEngineReport& engine = scene.m_stdEngines[e];
    const CSummary& error = engine.m_cTotals["direction_error"];
    const CMedian& ns = engine.m_cCost.m_cNsPerBallStep;
    if (error.m_nCount > 0)
      chart.m_stdPoints.push_back({&GetEngineRow(report.m_stdEngines[e].m_sName), ns.m_fMedian,
                                   ns.m_cInterval, error.m_fP95, CInterval{error.m_fMedian, error.m_fMax},
                                   engine.m_cTotals.GetTunneled(), engine.m_cTotals.m_nContacts, false});
  }
  for (CChartPoint& p : chart.m_stdPoints)
    p.m_bFront =
        std::none_of(chart.m_stdPoints.begin(), chart.m_stdPoints.end(), [&](const CChartPoint& other) {
          return other.m_fNs < p.m_fNs && other.m_fError <= p.m_fError;
        });
  chart.m_sTitle = Describe(chart, "Time against error in " + scene.m_cScene.m_sName);
  return chart;
}

std::string DrawChart(const CChart& chart, const CChartSize& size, bool isAlone) {
  return CDrawing(chart, size, isAlone).Draw();
}

std::string MakeChartsJson(const CRunReport& report) {
  const CChart overall = MakeOverallChart(report, MakeOverall(report));
  nlohmann::ordered_json json{
      {"overall", {DrawChart(overall, g_cWideChart, false), DrawChart(overall, g_cNarrowChart, false)}},
      {"scenes", nlohmann::ordered_json::object()}};
  for (const CSceneReport& scene : report.m_stdScenes)
    json["scenes"][scene.m_cScene.m_sName] = DrawChart(MakeSceneChart(report, scene), g_cNarrowChart, false);
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace Shapes::Compare
