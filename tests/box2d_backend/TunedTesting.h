// SPDX-License-Identifier: MIT
// Tests of the tuned profile share these: worlds of each tuning, and shots at static shapes whose resolution
// the exact reference knows. Everything is met at the distance r; ends of segments and arcs are round.
#pragma once

#include "Box2DTesting.h"
#include "box2d_backend/world/OwnedEngine.h"
#include "geometry/ImpactTesting.h"
#include "reference/Distance.h"

namespace Shapes::Tests {

inline constexpr double g_fDegree = std::numbers::pi / 180;
/// How far from where it is a tuned world may take a surface to be, in metres.
inline constexpr double g_fTunedOffset = 0.001;

using Box2D::CTuning;
using Box2D::g_cShipped;
using Box2D::g_cTuned;

/// The tuned profile with one switch turned off.
inline CTuning Without(bool CTuning::*pSwitch) {
  CTuning tuning = g_cTuned;
  tuning.*pSwitch = false;
  return tuning;
}

/// A world whose listener counts contacts if events are forced.
inline std::unique_ptr<CWorld> MakeBox2D(const CTuning& tuning, const Vector2& gravity = Vector2::Zero(),
                                         float dt = g_fDt, const CEffects& forced = {}) {
  CWorldDesc desc;
  desc.m_vGravity = gravity;
  desc.m_fTimeStep = dt;
  desc.m_cEffects.m_cForced = forced;
  return Box2D::MakeWorld(desc, tuning);
}

/// In [-most, most].
template <class T = double>
T EitherSign(CRandom& random, double most) {
  return static_cast<T>((2 * random.Unit() - 1) * most);
}

/// The value below which the share q of them lies. @param values not empty
inline double Quantile(std::vector<double> values, double q) {
  const auto i = static_cast<std::ptrdiff_t>(std::lround(q * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + i, values.end());
  return values[static_cast<std::size_t>(i)];
}

using CFigure = Compare::CShapeGeometry<double>;
/// A ball on its way: exactly what the floats that an engine is given say.
using CBallState = Compare::CSweptBall<double>;
using CHit = Compare::CHit<double>;

inline constexpr double g_fNever = std::numeric_limits<double>::infinity();

/// When and where the ball meets the shape, within so many seconds.
inline CHit Meet(const CFigure& shape, const CBallState& b, double seconds) {
  CHit hit;
  return Compare::Sweep<double>(shape, b, seconds, hit) ? hit : CHit{.m_fTime = g_fNever};
}

/// Shapes that do not move.
class CExactTable {
public:
  explicit CExactTable(const std::vector<CAnyShapeDesc>& descs) {
    for (const CAnyShapeDesc& desc : descs)
      m_stdShapes.push_back(Geometry::ForReference(Geometry::MakeShapeGeometry(*MakeShape(desc), 0.0)));
  }

  CHit FirstHit(const CBallState& b, double seconds = 1000) const {
    CHit first{.m_fTime = g_fNever};
    for (const CFigure& shape : m_stdShapes)
      if (const CHit hit = Meet(shape, b, seconds); hit.m_fTime < first.m_fTime) first = hit;
    return first;
  }

  /// Every hit within so many seconds, and the ball after them.
  std::vector<CHit> Fly(CBallState& b, double seconds) const {
    std::vector<CHit> hits;
    double now = 0;
    while (hits.size() < 1000) {
      CHit hit = FirstHit(b, seconds - now);
      if (now + hit.m_fTime > seconds) break;
      b.m_vPos += hit.m_fTime * b.m_vVel;
      b.m_vVel = Mirrored(b.m_vVel, hit.m_vNorm);
      hit.m_fTime = now += hit.m_fTime;
      hits.push_back(hit);
    }
    b.m_vPos += (seconds - now) * b.m_vVel;
    return hits;
  }

  /// Distance of p from the nearest surface.
  double Distance(const Vector2d& p) const {
    double d = g_fNever;
    for (const CFigure& shape : m_stdShapes)
      d = std::min(d, Compare::Distance<double>(shape, p));
    return d;
  }

private:
  std::vector<CFigure> m_stdShapes;
};

/// The plan of a shot.
struct CAim {
  Vector2d m_vSurface, m_vNorm; // where to hit; the normal points to the ball
  double m_fIncidence;          // radians from the normal, of either sign
  double m_fSpeed;              // units per second
  double m_fPhase;              // share of a step, [0, 1)
  int m_nMostHits = 1;          // before it is looked at
};

/// A shot whose exact velocity after a number of steps is known.
struct CShot {
  Vector2 m_vPos, m_vVel;
  int m_nSteps;        // after which it is looked at
  Vector2d m_vExact;   // velocity then
  double m_fAllowance; // most radians by which surfaces that are g_fTunedOffset off turn it
};

/// A shooting range: static shapes, exact and in a world, and one ball.
class CRange {
public:
  /// @param pWorld empty, without gravity, with steps of g_fDt
  CRange(std::unique_ptr<CWorld> pWorld, const std::vector<CAnyShapeDesc>& shapes, float radius)
      : m_cTable(shapes), m_pWorld(std::move(pWorld)), m_fRadius(radius) {
    for (const CAnyShapeDesc& shape : shapes)
      m_pWorld->Add(shape);
    m_cBall = m_pWorld->Add(CDynamicCircleDesc({50, 50}, radius));
  }

  const CWorld& World() const { return *m_pWorld; }

  /// A shot that meets the shapes where it is aimed at. None if something is in the way, or if the exact ball
  /// is about to hit something at the end of every step at which it could be looked at.
  std::optional<CShot> Aim(const CAim& aim) const {
    const double r = m_fRadius, dt = g_fDt;
    const Vector2d n = aim.m_vNorm, centre = aim.m_vSurface + r * n;
    const Vector2d u = -std::cos(aim.m_fIncidence) * n + std::sin(aim.m_fIncidence) * Perp(n);
    // Clear of any skin at first, if there is room for that.
    const double room = 0.9 * m_cTable.FirstHit({centre + 1e-6 * n, -u, r}).m_fTime;
    double way = 0.03 / std::cos(aim.m_fIncidence) + aim.m_fPhase * aim.m_fSpeed * dt;
    if (way > room) way = room * (0.5 + 0.5 * aim.m_fPhase);

    CShot shot;
    shot.m_vPos = (centre - way * u).cast<float>();
    shot.m_vVel = (aim.m_fSpeed * u).cast<float>();
    const CBallState start{shot.m_vPos.cast<double>(), shot.m_vVel.cast<double>(), r};
    if (m_cTable.Distance(start.m_vPos) <= r) return {};
    CBallState ball = start;
    const std::vector<CHit> hits = m_cTable.Fly(ball, way / aim.m_fSpeed + 10 * dt);
    if (hits.empty() || hits[0].m_vNorm.dot(u) > -0.05) return {}; // it passes, or only brushes past
    if ((start.m_vPos + hits[0].m_fTime * start.m_vVel - centre).norm() > 1e-3) return {};

    const int first = static_cast<int>(hits[0].m_fTime / dt) + 1;
    for (int steps = first + 4; steps >= first; --steps) {
      const double t = steps * dt;
      const auto before = [&](const CHit& hit) { return hit.m_fTime < t; };
      if (std::count_if(hits.begin(), hits.end(), before) > aim.m_nMostHits) continue;
      if (IsHitAbout(hits, start.m_vVel, t)) continue;
      shot.m_nSteps = steps;
      shot.m_vExact = VelocityAt(start, t);
      shot.m_fAllowance = Allowance(start, t);
      return shot;
    }
    return {};
  }

  /// Radians between the velocity of the ball after the steps of the shot and the exact one.
  double DirectionError(const CShot& shot) {
    m_pWorld->SetPos(m_cBall, shot.m_vPos);
    m_pWorld->SetVel(m_cBall, shot.m_vVel);
    Steps(*m_pWorld, shot.m_nSteps);
    return AngleBetween(m_pWorld->GetVel(m_cBall).cast<double>(), shot.m_vExact);
  }

  /// Direction errors of n of the shots that `aim` aims.
  template <class TAim>
  std::vector<double> Errors(std::size_t n, TAim aim) {
    std::vector<double> errors;
    while (errors.size() < n)
      if (const auto shot = Aim(aim())) errors.push_back(DirectionError(*shot));
    return errors;
  }

  /// How many of n shots are off by more than .01 radians and what surfaces that are g_fTunedOffset off
  /// explain. Shots that a surface so little off turns by more than mostAllowance have no resolution and are
  /// left out.
  template <class TAim>
  int CountWrong(int n, TAim aim, double mostAllowance = std::numeric_limits<double>::infinity()) {
    int wrong = 0;
    while (n > 0)
      if (const auto shot = Aim(aim()); shot && shot->m_fAllowance <= mostAllowance) {
        --n;
        wrong += DirectionError(*shot) > 0.01 + shot->m_fAllowance;
      }
    return wrong;
  }

private:
  Vector2d VelocityAt(CBallState ball, double t) const {
    m_cTable.Fly(ball, t);
    return ball.m_vVel;
  }

  // Whether a hit may be on either side of t for an engine whose surfaces are a little off.
  static bool IsHitAbout(const std::vector<CHit>& hits, Vector2d v, double t) {
    for (const CHit& hit : hits) {
      const double margin = 0.05 * g_fDt + 3 * g_fTunedOffset / std::abs(v.dot(hit.m_vNorm));
      if (std::abs(t - hit.m_fTime) < margin) return true;
      v = Mirrored(v, hit.m_vNorm);
    }
    return false;
  }

  // Surfaces that are off along their normals are a ball of another radius; near ends and sharedEnds it
  // counts too on which side of them the ball passes.
  double Allowance(const CBallState& start, double t) const {
    const Vector2d exact = VelocityAt(start, t), across = g_fTunedOffset * Perp(start.m_vVel.normalized());
    double most = 0;
    for (const double sign : {-1.0, 1.0}) {
      CBallState aside = start, other = start;
      aside.m_vPos += sign * across;
      other.m_fRadius += sign * g_fTunedOffset;
      most = std::max(
          {most, AngleBetween(VelocityAt(aside, t), exact), AngleBetween(VelocityAt(other, t), exact)});
    }
    return most;
  }

  CExactTable m_cTable;
  std::unique_ptr<CWorld> m_pWorld;
  CShapeId m_cBall;
  float m_fRadius;
};

} // namespace Shapes::Tests
