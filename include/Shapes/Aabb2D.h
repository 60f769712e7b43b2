// SPDX-License-Identifier: MIT
// Axially aligned bounding box. y is up: the top is never below the bottom.
#pragma once

#include <Shapes/ShapeMath.h>

#include <utility>

namespace Shapes {

/// A box given by its top left and bottom right corner, in the user's length unit. Its edges belong to it.
/// A box with a NaN coordinate intersects nothing.
class CAabb2D {
public:
  /// The empty box: intersects nothing, has no width; `+=` makes it the box of one point.
  CAabb2D();
  /// The box with these opposite corners; corners given in another order are put in order.
  CAabb2D(const Vector2& topleft, const Vector2& bottomright)
      : m_vTopLeft(topleft), m_vBottomRt(bottomright) {
    if (m_vTopLeft.x() > m_vBottomRt.x()) std::swap(m_vTopLeft.x(), m_vBottomRt.x());
    if (m_vTopLeft.y() < m_vBottomRt.y()) std::swap(m_vTopLeft.y(), m_vBottomRt.y());
  }

  /// Shrinks the box to the point p.
  CAabb2D& operator=(const Vector2& p) {
    m_vTopLeft = m_vBottomRt = p;
    return *this;
  }
  /// Grows the box just enough to contain the point p.
  CAabb2D& operator+=(const Vector2& p);
  CAabb2D& operator+=(const CAabb2D& box) { return (*this += box.m_vTopLeft) += box.m_vBottomRt; }

  /// Whether the boxes share at least one point.
  friend bool operator&&(const CAabb2D& a, const CAabb2D& b);
  /// Whether the point p is in the box.
  friend bool operator&&(const CAabb2D& a, const Vector2& p);

  /// Moves the box by v. Each coordinate is rounded once: error at most half an ulp of it.
  void Translate(const Vector2& v);

  /// Width and height, 0 for the empty box. Rounded once.
  float GetWidth() const;
  float GetHt() const;
  const Vector2& GetTopLeft() const { return m_vTopLeft; }
  const Vector2& GetBottomRt() const { return m_vBottomRt; }

private:
  Vector2 m_vTopLeft;
  Vector2 m_vBottomRt;
};

// In the header: the broad phase calls them for every node it visits.
inline bool operator&&(const CAabb2D& a, const CAabb2D& b) {
  return a.m_vBottomRt.x() >= b.m_vTopLeft.x() && a.m_vTopLeft.x() <= b.m_vBottomRt.x() &&
         a.m_vBottomRt.y() <= b.m_vTopLeft.y() && a.m_vTopLeft.y() >= b.m_vBottomRt.y();
}

inline bool operator&&(const CAabb2D& a, const Vector2& p) {
  return a.m_vTopLeft.x() <= p.x() && p.x() <= a.m_vBottomRt.x() && a.m_vBottomRt.y() <= p.y() &&
         p.y() <= a.m_vTopLeft.y();
}

inline CAabb2D& CAabb2D::operator+=(const Vector2& p) {
  // Least and greatest of two, except that a NaN stays a NaN whichever side it came in on.
  const auto least = [](float a, float b) { return b < a || b != b ? b : a; };
  const auto greatest = [](float a, float b) { return b > a || b != b ? b : a; };
  m_vTopLeft = {least(m_vTopLeft.x(), p.x()), greatest(m_vTopLeft.y(), p.y())};
  m_vBottomRt = {greatest(m_vBottomRt.x(), p.x()), least(m_vBottomRt.y(), p.y())};
  return *this;
}

} // namespace Shapes
