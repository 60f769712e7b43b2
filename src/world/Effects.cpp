// SPDX-License-Identifier: MIT
#include "Effects.h"

#include "../geometry/Reach.h"
#include "../shapes/Validate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Shapes {
namespace {

std::string Plural(std::size_t n, const std::string& one, const std::string& more) {
  return std::to_string(n) + " " + (n == 1 ? one : more);
}

// Three digits are enough to tell by.
std::string Rounded(double x) {
  if (!(x >= 1e-3 && x < 1e6)) return ToText(static_cast<float>(x));
  const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(x))), 0, 5);
  std::string text = std::to_string(std::round(x * std::pow(10.0, digits)) / std::pow(10.0, digits));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string Why(eEffect e, const CContent& c, const CWorldState& state, const CLongestMoves& moves) {
  switch (e) {
  case eEffect::Gravity:
    return "gravity is " + ToText(state.m_vGravity) + ", " + Plural(c.m_nBalls, "ball", "balls");
  case eEffect::Kinematics: return Plural(c.m_nMoving, "shape moves or rotates", "shapes move or rotate");
  case eEffect::BallPairs: return Plural(c.m_nSolidBalls, "solid ball", "solid balls");
  case eEffect::Sensors:
    return Plural(c.m_nSensors, "sensor", "sensors") +
           (state.m_stdTouching.empty()
                ? ""
                : ", " + Plural(state.m_stdTouching.size(), "pair touches", "pairs touch"));
  case eEffect::Events:
    return Plural(c.m_nSolidBalls, "solid ball", "solid balls") + ", " +
           Plural(c.m_nSolidShapes, "solid shape", "solid shapes") + ", " +
           Plural(c.m_nSensors, "sensor", "sensors");
  case eEffect::Continuous:
    return "the fastest ball moves " + Rounded(moves.m_fBall) + " radii a substep" +
           (moves.m_fSurface > 0.0
                ? ", the fastest surface " + Rounded(moves.m_fSurface) + " of the smallest ball"
                : "");
  case eEffect::Size: break;
  }
  return {};
}

} // namespace

std::string_view GetName(eEffect e) {
  switch (e) {
  case eEffect::Gravity: return "Gravity";
  case eEffect::Kinematics: return "Kinematics";
  case eEffect::BallPairs: return "BallPairs";
  case eEffect::Sensors: return "Sensors";
  case eEffect::Events: return "Events";
  case eEffect::Continuous: return "Continuous";
  case eEffect::Size: break;
  }
  return {};
}

CContent CContent::Of(const CShapeEntry& entry) {
  const CShape& shape = *entry.m_pShape;
  CContent c;
  c.m_nMoving = shape.GetMotionType() == eMotion::Kinematic &&
                (entry.m_fRotSpeed != 0.0f || entry.m_vVel != Vector2::Zero());
  c.m_nSensors = shape.GetSensor();
  c.m_nSolidShapes = shape.GetCanCollide() && !shape.GetSensor();
  return c;
}

CContent CContent::Of(const CBallArrays& balls, std::size_t i) {
  CContent c;
  c.m_nBalls = 1;
  c.m_nSolidBalls = balls.IsSolid(i);
  c.m_nSensors = balls.m_stdSensor[i] != 0;
  return c;
}

CContent& CContent::operator+=(const CContent& other) {
  m_nBalls += other.m_nBalls;
  m_nSolidBalls += other.m_nSolidBalls;
  m_nSolidShapes += other.m_nSolidShapes;
  m_nMoving += other.m_nMoving;
  m_nSensors += other.m_nSensors;
  return *this;
}

CContent& CContent::operator-=(const CContent& other) {
  m_nBalls -= other.m_nBalls;
  m_nSolidBalls -= other.m_nSolidBalls;
  m_nSolidShapes -= other.m_nSolidShapes;
  m_nMoving -= other.m_nMoving;
  m_nSensors -= other.m_nSensors;
  return *this;
}

CContent CountContent(const CWorldState& state) {
  CContent c;
  for (std::size_t i = 0; i < state.m_cBalls.Size(); ++i)
    c += CContent::Of(state.m_cBalls, i);
  for (const CShapeEntry& entry : state.m_stdShapes)
    c += CContent::Of(entry);
  return c;
}

CEffects GetCalledFor(const CContent& c, const CWorldState& state) {
  CEffects called;
  called.Set(eEffect::Gravity, c.m_nBalls > 0 && state.m_vGravity != Vector2::Zero());
  called.Set(eEffect::Kinematics, c.m_nMoving > 0);
  called.Set(eEffect::BallPairs, c.m_nSolidBalls > 1);
  called.Set(eEffect::Sensors, c.m_nSensors > 0 || !state.m_stdTouching.empty());
  called.Set(eEffect::Events, c.CanMeet() || called.Has(eEffect::Sensors));
  return called;
}

void CFastMoves::SetBalls(const CBallArrays& b, float dt) {
  const double s = static_cast<double>(g_fFastMove) / dt;
  m_fSmallest = std::numeric_limits<double>::infinity();
  m_stdLimits.clear();
  for (std::size_t i = 0; i < b.Size(); ++i) {
    const double limit = b.IsSolid(i) ? s * b.m_stdRadius[i] : std::numeric_limits<double>::infinity();
    const double square = limit * limit, most = std::numeric_limits<float>::max();
    m_stdLimits.push_back(square < 1e-30 ? 0.0f : static_cast<float>(std::min(square, most)));
    m_fSmallest = std::min(m_fSmallest, limit * dt);
  }
}

void CFastMoves::SetSurfaces(const CWorldState& state, float dt) {
  m_fSurface = FindLongestSurfaceMove(state, dt);
}

double FindLongestSurfaceMove(const CWorldState& state, float dt) {
  double longest = 0.0;
  for (const CShapeEntry& entry : state.m_stdShapes) {
    const CShape& shape = *entry.m_pShape;
    if (!shape.GetMoving() || !shape.GetCanCollide() || shape.GetSensor()) continue;
    const double turn = static_cast<double>(g_fTwoPi) * std::abs(shape.GetRotSpeed()) * dt;
    longest = std::max(longest, turn * GetReach(shape) + shape.GetVel().cast<double>().norm() * dt);
  }
  return longest;
}

CLongestMoves FindLongestMoves(const CWorldState& state, const Vector2& gravityStep, float dt) {
  CLongestMoves moves;
  const CBallArrays& b = state.m_cBalls;
  const double surface = FindLongestSurfaceMove(state, dt);
  for (std::size_t i = 0; i < b.Size(); ++i) {
    if (!b.IsSolid(i)) continue;
    const double path = (b.m_stdVel[i] + gravityStep).cast<double>().norm() * dt, r = b.m_stdRadius[i];
    // A ball may be a point.
    const auto inRadii = [&](double length) {
      return r > 0.0 || length == 0.0 ? length / (r > 0.0 ? r : 1.0)
                                      : std::numeric_limits<double>::infinity();
    };
    moves.m_fBall = std::max(moves.m_fBall, inRadii(path));
    moves.m_fSurface = std::max(moves.m_fSurface, inRadii(surface));
  }
  return moves;
}

std::string Explain(CEffects running, const CEffectChoice& choice, CEffects engineNeeds, CEffects given,
                    const CContent& c, const CWorldState& state, const CLongestMoves& moves) {
  std::string text;
  for (int i = 0; i < static_cast<int>(eEffect::Size); ++i) {
    const auto e = static_cast<eEffect>(i);
    text += GetName(e);
    text += running.Has(e) ? ": runs" : ": does not run";
    if (choice.m_cForced.Has(e))
      text += ", forced by the description";
    else if (choice.m_cForbidden.Has(e))
      text += ", forbidden by the description";
    else if (given.Has(e))
      text += ", decided by the world around";
    else if (engineNeeds.Has(e))
      text += ", as always in this engine";
    text += "; " + Why(e, c, state, moves) + "\n";
  }
  return text;
}

} // namespace Shapes
