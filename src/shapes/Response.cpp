// SPDX-License-Identifier: MIT
#include "Response.h"

namespace Shapes {
namespace {

// The velocity that a response adds along n. It is cut to stay finite, as the surface of a shape far from its
// centre may be faster than any ball; CapSpeed does the rest.
template <class T>
T NormalImpulse(T e, T vn) {
  return (T(1) + e) * std::max(vn, -T(g_fMaxApproach));
}

// Names of their own: as overloads of Length and Normalize they would make Length({x, y}) ambiguous.
float GetSpeed(const Vector2& v) { return Length(v); }
double GetSpeed(const Eigen::Vector2d& v) { return v.norm(); }
Vector2 GetDirection(const Vector2& v) { return Normalize(v); }
Eigen::Vector2d GetDirection(const Eigen::Vector2d& v) { return v.normalized(); }

} // namespace

template <class TVector>
bool CutSpeed(TVector& v, float most) {
  const typename TVector::Scalar limit(most);
  FailIf(GetSpeed(v) <= limit);
  v = limit * GetDirection(v);
  return true;
}

template <class TVector, class T>
void RespondKinematic(const TVector& n, T setback, T e, const TVector& surface, TVector& p, TVector& v) {
  const T vn = (v - surface).dot(n);
  if (vn < T(0)) v -= NormalImpulse(e, vn) * n;
  p += setback * n;
}

template <class TVector, class T>
void RespondDynamic(const TVector& n, T setback, T e, T m0, T m1, TVector& p0, TVector& v0, TVector& p1,
                    TVector& v1) {
  // As shares of the total mass: the product of two masses may overflow, the shares cannot.
  const T share0 = m1 / (m0 + m1), share1 = m0 / (m0 + m1);
  const T vn = (v1 - v0).dot(n);
  if (vn < T(0)) {
    v0 += (NormalImpulse(e, vn) * share0) * n;
    v1 -= (NormalImpulse(e, vn) * share1) * n;
  }
  p0 -= (setback * share0) * n;
  p1 += (setback * share1) * n;
}

template bool CutSpeed(Vector2&, float);
template bool CutSpeed(Eigen::Vector2d&, float);
template void RespondKinematic(const Vector2&, float, float, const Vector2&, Vector2&, Vector2&);
template void RespondKinematic(const Eigen::Vector2d&, double, double, const Eigen::Vector2d&,
                               Eigen::Vector2d&, Eigen::Vector2d&);
template void RespondDynamic(const Vector2&, float, float, float, float, Vector2&, Vector2&, Vector2&,
                             Vector2&);
template void RespondDynamic(const Eigen::Vector2d&, double, double, double, double, Eigen::Vector2d&,
                             Eigen::Vector2d&, Eigen::Vector2d&, Eigen::Vector2d&);

} // namespace Shapes
