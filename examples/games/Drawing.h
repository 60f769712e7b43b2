// SPDX-License-Identifier: MIT
// A game as rows of numbers that are drawn: by the page, and as a picture.
#pragma once

#include "Game.h"

#include <string>
#include <vector>

namespace Shapes::Games {

enum class eRow { Point, Segment, Circle, Arc };

/// Point: (x, y). Segment: (x, y) to (x1, y1). Circle and arc: centre, radius, and the angles of the arc.
struct CRow {
  float m_fKind, m_fRole; ///< eRow and eRole, as floats: the page reads the rows as one array of these.
  float m_fX, m_fY;
  float m_fX1, m_fY1;
  float m_fRadius, m_fAngle0, m_fAngle1;
};

/// Shapes first, by id, then balls.
std::vector<CRow> Draw(const CGame& game);
/// The rows as an SVG picture, in the colours of the page.
std::string ToSvg(const CGame& game);

} // namespace Shapes::Games
