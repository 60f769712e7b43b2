// SPDX-License-Identifier: MIT
// The drawing of a world, and the drawn figures of documents: each is what the drawing here gives.

#include <fstream>

#include "../Testing.h"

namespace Shapes {
namespace {

// Writes down the calls.
class CCalls final : public CDebugDraw {
public:
  std::string m_sText;
  void DrawPoint(const Vector2& p, eRole role) override { Add("point", p, role); }
  void DrawSegment(const Vector2& p0, const Vector2&, eRole role) override { Add("segment", p0, role); }
  void DrawCircle(const Vector2& center, float, eRole role) override { Add("circle", center, role); }
  void DrawArc(const Vector2& center, float, float, float, eRole role) override { Add("arc", center, role); }
  void DrawText(const Vector2& p, std::string_view, eRole role) override { Add("text", p, role); }

private:
  void Add(const char* what, const Vector2& p, eRole role) {
    std::ostringstream text;
    text << what << ' ' << p.x() << ' ' << p.y() << ' ' << static_cast<int>(role) << '\n';
    m_sText += text.str();
  }
};

std::string RolesAre(eRole role) { return " " + std::to_string(static_cast<int>(role)) + "\n"; }

TEST(DebugDraw, AWorldIsItsShapesItsBallsAndItsContacts) {
  const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(CWorldDesc());
  pWorld->Add(CPointDesc(Vector2(1, 1)));
  pWorld->Add(Turning(CLineSegDesc({2, 0}, {2, 1})));
  pWorld->Add(MakeZone({3, 3}));
  const CShapeId off = pWorld->Add(CArcDesc({4, 4}, 1, 0, 2));
  pWorld->SetCanCollide(off, false);
  pWorld->Add(CArcDesc({6, 6}, 1, 1, 1));
  pWorld->Add(CDynamicCircleDesc({2.5f, 0.5f}, 0.25f, {-60, 0}));
  pWorld->Step();
  ASSERT_EQ(pWorld->GetContacts().size(), 1u);
  CCalls calls;
  Draw(*pWorld, calls);
  const std::string drawn = calls.m_sText,
                    shapes = "point 1 1" + RolesAre(eRole::Static) + "segment 2 0" +
                             RolesAre(eRole::Kinematic) + "circle 3 3" + RolesAre(eRole::Sensor) + "arc 4 4" +
                             RolesAre(eRole::Off) + "circle 6 6" + RolesAre(eRole::Static) + "circle ";
  EXPECT_TRUE(drawn.starts_with(shapes)) << drawn;
  EXPECT_TRUE(Says(drawn, RolesAre(eRole::Ball) + "point 2 0.5" + RolesAre(eRole::Contact) + "segment 2 0.5" +
                              RolesAre(eRole::Contact)));
}

TEST(DebugDraw, SvgIsInPixelsWithYDown) {
  CSvgDraw svg(CAabb2D({-1, 2}, {3, -1}), 10);
  svg.DrawSegment({-1, 2}, {3, -1}, eRole::Static);
  svg.DrawCircle({0, 0}, 0.5f, eRole::Ball);
  svg.DrawArc({0, 0}, 1, 0, 1.5f * g_fPi, eRole::Sensor);
  svg.DrawPoint({1, 1}, eRole::Contact);
  svg.DrawText({0, 1}, "a < b & c", eRole::Text);
  EXPECT_EQ(svg.GetText(), R"(<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30" fill="none" )"
                           R"(stroke-width="1.5" font-family="sans-serif" font-size="13">
<rect width="100%" height="100%" fill="#fff"/>
<line x1="0" y1="0" x2="40" y2="30" stroke="#333"/>
<circle cx="10" cy="20" r="5" stroke="#06c"/>
<path d="M20 20A10 10 0 1 0 10 30" stroke="#292" stroke-dasharray="4 3"/>
<circle cx="20" cy="10" r="2" stroke="#d00"/>
<text x="10" y="10" fill="#000">a &lt; b &amp; c</text>
</svg>
)");
}

TEST(DebugDraw, WhatCannotBeDrawnIsRefused) {
  EXPECT_THROW(CSvgDraw(CAabb2D({0, 1}, {1, 0}), 0), std::invalid_argument);
  EXPECT_THROW(CSvgDraw(CAabb2D({g_fInf, 1}, {1, 0}), 1), std::invalid_argument);
}

// An arrow with its name at its tip.
void DrawArrow(CDebugDraw& draw, const Vector2& from, const Vector2& way, std::string_view name, eRole role) {
  const Vector2 to = from + way, back = -0.08f * Normalize(way), aside = 0.5f * perp(back);
  draw.DrawSegment(from, to, role);
  draw.DrawSegment(to, to + back + aside, role);
  draw.DrawSegment(to, to + back - aside, role);
  draw.DrawText(to + Vector2(0.05f, 0.03f), name, eRole::Text);
}

// docs/arc.svg: whoever changes it on purpose puts the text there that the test prints.
TEST(DebugDraw, TheFigureOfAnArcIsThatOfTheDocument) {
  const CArc arc(CArcDesc({0, 0}, 1, 0, 0.5f * g_fPi));
  Vector2 t0, t1;
  arc.GetTangents(t0, t1);
  CSvgDraw svg(CAabb2D({-0.3f, 1.35f}, {1.75f, -0.2f}), 160);
  svg.DrawArc(arc.GetPos(), arc.GetRadius(), arc.GetAngle0(), arc.GetSpan(), eRole::Static);
  for (const Vector2& end : {arc.GetEndPt0(), arc.GetEndPt1()}) {
    svg.DrawSegment(arc.GetPos(), end, eRole::Off);
    svg.DrawPoint(end, eRole::Static);
  }
  svg.DrawPoint(arc.GetPos(), eRole::Static);
  DrawArrow(svg, arc.GetEndPt0(), 0.35f * t0, "t0", eRole::Kinematic);
  DrawArrow(svg, arc.GetEndPt1(), 0.35f * t1, "t1", eRole::Kinematic);
  svg.DrawText({-0.1f, -0.12f}, "c", eRole::Text);
  svg.DrawText(arc.GetEndPt0() + Vector2(0.05f, -0.12f), "p0, at angle 0", eRole::Text);
  svg.DrawText(arc.GetEndPt1() + Vector2(-0.2f, 0.1f), "p1, at angle 1", eRole::Text);
  std::ostringstream kept;
  kept << std::ifstream(SHAPES_SOURCE_DIR "/docs/arc.svg", std::ios::binary).rdbuf();
  EXPECT_EQ(svg.GetText(), kept.str()) << svg.GetText();
}

} // namespace
} // namespace Shapes
