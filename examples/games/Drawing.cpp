// SPDX-License-Identifier: MIT
#include "Drawing.h"

#include <cmath>
#include <sstream>

namespace Shapes::Games {
namespace {

CRow Row(eRow kind, eRole role, const Vector2& p) {
  CRow row{};
  row.m_fKind = static_cast<float>(kind);
  row.m_fRole = static_cast<float>(role);
  row.m_fX = p.x();
  row.m_fY = p.y();
  return row;
}

CRow RowOf(const CShape& shape, eRole role) {
  CRow row = Row(eRow::Point, role, shape.GetPos());
  if (shape.GetShapeType() == eShape::LineSeg) {
    const auto& segment = static_cast<const CLineSeg&>(shape);
    row = Row(eRow::Segment, role, segment.GetEndPt0());
    row.m_fX1 = segment.GetEndPt1().x();
    row.m_fY1 = segment.GetEndPt1().y();
  } else if (shape.GetShapeType() == eShape::Circle) {
    row = Row(eRow::Circle, role, shape.GetPos());
    row.m_fRadius = static_cast<const CCircle&>(shape).GetRadius();
  } else if (shape.GetShapeType() == eShape::Arc) {
    const auto& arc = static_cast<const CArc&>(shape);
    row = Row(arc.IsFullCircle() ? eRow::Circle : eRow::Arc, role, shape.GetPos());
    row.m_fRadius = arc.GetRadius();
    row.m_fAngle0 = arc.GetAngle0();
    row.m_fAngle1 = arc.GetAngle1();
  }
  return row;
}

const char* GetColour(eRole role) {
  switch (role) {
  case eRole::Wall: return "#545d68";
  case eRole::Kicker: return "#c2410c";
  case eRole::Flipper: return "#0067b1";
  case eRole::Sensor: return "#b9c2cb";
  case eRole::Lit: return "#d99a00";
  case eRole::Gate: return "#0f7b55";
  case eRole::Ball: return "#1b1f24";
  }
  return "";
}

} // namespace

std::vector<CRow> Draw(const CGame& game) {
  const CWorld& world = game.GetWorld();
  std::vector<CRow> rows;
  for (const CShapeId id : world.GetShapeIds())
    rows.push_back(RowOf(world.GetShape(id), game.GetRole(id)));
  for (std::size_t i = 0; i < world.GetBallIds().size(); ++i) {
    rows.push_back(Row(eRow::Circle, eRole::Ball, world.GetBallPositions()[i]));
    rows.back().m_fRadius = world.GetRadius(world.GetBallIds()[i]);
  }
  return rows;
}

std::string ToSvg(const CGame& game) {
  const CAabb2D& box = game.GetBounds();
  const float top = box.GetTopLeft().y();
  std::ostringstream svg;
  svg.precision(5);
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" << box.GetTopLeft().x() << " 0 "
      << box.GetWidth() << ' ' << box.GetHt() << "\" width=\"" << 30 * box.GetWidth()
      << "\" stroke-width=\"0.12\" stroke-linecap=\"round\" fill=\"none\">\n"
      << "<rect x=\"" << box.GetTopLeft().x() << "\" width=\"" << box.GetWidth() << "\" height=\""
      << box.GetHt() << "\" fill=\"#f5f6f8\"/>\n";
  for (const CRow& row : Draw(game)) {
    const auto role = static_cast<eRole>(static_cast<int>(row.m_fRole));
    const float x = row.m_fX, y = top - row.m_fY, r = row.m_fRadius;
    const std::string paint = std::string(" stroke=\"") + GetColour(role) + "\"";
    switch (static_cast<eRow>(static_cast<int>(row.m_fKind))) {
    case eRow::Point:
      svg << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"0.06\"" << paint << "/>\n";
      break;
    case eRow::Segment:
      svg << "<path d=\"M" << x << ' ' << y << 'L' << row.m_fX1 << ' ' << top - row.m_fY1 << "\"" << paint
          << "/>\n";
      break;
    case eRow::Circle:
      svg << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << r << "\"" << paint
          << (role == eRole::Ball ? " fill=\"#8b95a1\"" : "") << "/>\n";
      break;
    case eRow::Arc: {
      const Vector2 p0 = r * AngleToVector(row.m_fAngle0), p1 = r * AngleToVector(row.m_fAngle1);
      const bool isLarge = NormalizeAngle(row.m_fAngle1 - row.m_fAngle0) > g_fPi;
      svg << "<path d=\"M" << x + p0.x() << ' ' << y - p0.y() << 'A' << r << ' ' << r << " 0 " << isLarge
          << " 0 " << x + p1.x() << ' ' << y - p1.y() << "\"" << paint << "/>\n";
      break;
    }
    }
  }
  svg << "</svg>\n";
  return svg.str();
}

} // namespace Shapes::Games
