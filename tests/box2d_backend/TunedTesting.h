// SPDX-License-Identifier: MIT
// Tests of the tuned profile share these: worlds of each tuning, and shots at static shapes whose resolution
// the exact reference knows. Everything is met at the distance r; ends of segments and arcs are round.
#pragma once

#include "Box2DTesting.h"
#include "box2d_backend/world/OwnedEngine.h"
#include "reference/Distance.h"
#include "reference/Reference.h"

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
  return Box2D::MakeWorld(Described(gravity, dt, 1, {forced, {}}), tuning);
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

inline constexpr double g_fNever = std::numeric_limits<double>::infinity();

/// One ball among static shapes, exactly.
class CExact {
public:
  CExact(std::span<const CAnyShapeDesc> shapes, float radius) {
    for (const double off : {0.0, g_fTunedOffset, -g_fTunedOffset})
      m_stdReferences.emplace_back(
          shapes, std::array{CDynamicCircleDesc({0, 0}, radius + static_cast<float>(off))}, Vector2(0, 0));
  }

  /// Every hit within so many seconds. @param off  1 and 2: of a ball that is larger or smaller by
  /// g_fTunedOffset
  std::vector<Compare::CExactEvent<double>> Fly(const Vector2d& p, const Vector2d& v, double seconds,
                                                std::size_t off = 0) {
    std::vector<Compare::CExactEvent<double>> hits;
    m_stdReferences[off].SetBall(0, p, v);
    m_stdReferences[off].Step(seconds, hits);
    return hits;
  }
  /// So many seconds later.
  Vector2d Velocity(const Vector2d& p, const Vector2d& v, double seconds, std::size_t off = 0) {
    Fly(p, v, seconds, off);
    return m_stdReferences[off].GetBall(0).m_vVel;
  }
  /// Most radians by which surfaces that are g_fTunedOffset off turn that velocity. Off along their normals
  /// they are a ball of another radius; near ends and joints it counts too on which side of them it passes.
  double Allowance(const Vector2d& p, const Vector2d& v, double seconds) {
    const Vector2d across = g_fTunedOffset * Perp(v.normalized()), exact = Velocity(p, v, seconds);
    double most = 0;
    for (const Vector2d& other : {Velocity(p + across, v, seconds), Velocity(p - across, v, seconds),
                                  Velocity(p, v, seconds, 1), Velocity(p, v, seconds, 2)})
      most = std::max(most, AngleBetween(other, exact));
    return most;
  }
  /// Whether a ball there is in a shape.
  bool Overlaps(const Vector2d& p) const {
    const auto& exact = m_stdReferences[0];
    for (std::size_t i = 0; i < exact.GetShapeCount(); ++i)
      if (Compare::Distance<double>(exact.GetGeometry(i), p) <= exact.GetBall(0).m_fRadius) return true;
    return false;
  }

private:
  std::vector<Compare::CReference<double>> m_stdReferences;
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
      : m_cExact(shapes, radius), m_pWorld(std::move(pWorld)), m_fRadius(radius) {
    for (const CAnyShapeDesc& shape : shapes)
      m_pWorld->Add(shape);
    m_cBall = m_pWorld->Add(CDynamicCircleDesc({50, 50}, radius));
  }

  /// A shot that meets the shapes where it is aimed at. None if something is in the way, or if the exact ball
  /// is about to hit something at the end of every step at which it could be looked at.
  std::optional<CShot> Aim(const CAim& aim) {
    const double r = m_fRadius, dt = g_fDt;
    const Vector2d n = aim.m_vNorm, centre = aim.m_vSurface + r * n;
    const Vector2d u = -std::cos(aim.m_fIncidence) * n + std::sin(aim.m_fIncidence) * Perp(n);
    // Clear of any skin at first, if there is room for that.
    double way = 0.03 / std::cos(aim.m_fIncidence) + aim.m_fPhase * aim.m_fSpeed * dt;
    if (const auto behind = m_cExact.Fly(centre + 1e-6 * n, -u, 2 * way); !behind.empty())
      if (const double room = 0.9 * behind[0].m_fTime; way > room) way = room * (0.5 + 0.5 * aim.m_fPhase);

    CShot shot;
    shot.m_vPos = (centre - way * u).cast<float>();
    shot.m_vVel = (aim.m_fSpeed * u).cast<float>();
    const Vector2d p = shot.m_vPos.cast<double>(), v = shot.m_vVel.cast<double>();
    if (m_cExact.Overlaps(p)) return {};
    const auto hits = m_cExact.Fly(p, v, way / aim.m_fSpeed + 10 * dt);
    if (hits.empty() || hits[0].m_vNorm.dot(u) > -0.05) return {}; // it passes, or only brushes past
    if ((hits[0].m_vCenter - centre).norm() > 1e-3) return {};

    const int first = static_cast<int>(hits[0].m_fTime / dt) + 1;
    for (int steps = first + 4; steps >= first; --steps) {
      const double t = steps * dt;
      const auto isBefore = [&](const auto& hit) { return hit.m_fTime < t; };
      // On either side of t for an engine whose surfaces are a little off.
      const auto isAbout = [&](const auto& hit) {
        const double speed = std::abs(hit.m_vVelBefore.dot(hit.m_vNorm));
        return std::abs(t - hit.m_fTime) < 0.05 * dt + 3 * g_fTunedOffset / speed;
      };
      if (std::ranges::count_if(hits, isBefore) > aim.m_nMostHits) continue;
      if (std::ranges::any_of(hits, isAbout)) continue;
      shot.m_nSteps = steps;
      shot.m_vExact = m_cExact.Velocity(p, v, t);
      shot.m_fAllowance = m_cExact.Allowance(p, v, t);
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
  CExact m_cExact;
  std::unique_ptr<CWorld> m_pWorld;
  CShapeId m_cBall;
  float m_fRadius;
};

} // namespace Shapes::Tests
