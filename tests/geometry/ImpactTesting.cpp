// SPDX-License-Identifier: MIT
#include "Tolerances.h"

#include "ImpactTesting.h"

namespace Shapes::Geometry {
namespace {

double Between(CRandom& random, double least, double most) { return least + (most - least) * random.Unit(); }
/// 10^least .. 10^most.
double Power(CRandom& random, double least, double most) {
  return std::pow(10.0, Between(random, least, most));
}
/// The same, of either sign.
double SignedPower(CRandom& random, double least, double most) {
  const double sign = random.Coin() ? 1.0 : -1.0;
  return sign * Power(random, least, most);
}
Vector2d Direction(CRandom& random) {
  const double a = Between(random, 0.0, 6.2831853);
  return {std::cos(a), std::sin(a)};
}
/// Of a length 10^least .. 10^most.
Vector2d Vector(CRandom& random, double least, double most) {
  const double length = Power(random, least, most);
  return length * Direction(random);
}

// A circle about which something happens: the shape's own, or none about a point of it.
struct CRim {
  Vector2d m_vCenter;
  double m_fRadius;
};
CRim RandomRim(CRandom& random, const CShapeGeometry& o) {
  if (o.m_eShapeType == eShape::Point) return {o.m_vCenter, 0.0};
  if (o.m_eShapeType == eShape::LineSeg) {
    const double share = random.Coin() ? static_cast<double>(random.Below(2)) : random.Unit();
    return {o.m_vPt0 + share * (o.m_vPt1 - o.m_vPt0), 0.0};
  }
  if (o.m_eShapeType == eShape::Arc && random.Coin()) return {random.Coin() ? o.m_vPt0 : o.m_vPt1, 0.0};
  return {o.m_vCenter, o.m_fRadius};
}

} // namespace

CShapeGeometry RandomOutline(CRandom& random, eShape type, eSides sides, bool turns) {
  const Vector2 p = random.InSquare(1.0f), q = random.InSquare(1.0f);
  const Vector2 center = random.Below(4) == 0 ? p : random.InSquare(1.0f);
  const float R = random.Below(4) == 0 ? random.Scale(-8, -1) : random.Uniform(0.05f, 1.0f);
  const auto make = [&](const auto& desc) {
    const auto pShape = MakeShape(turns ? Turning(desc, 0, center) : desc);
    return MakeShapeGeometry(*pShape, turns ? Between(random, -60.0, 60.0) : 0.0);
  };
  if (type == eShape::Point) return make(CPointDesc(p));
  if (type == eShape::LineSeg) {
    const CLineSegDesc desc(p, random.Below(4) == 0 ? Vector2(p + random.Vector(-12, -2)) : q);
    return make(Sided(desc, sides));
  }
  if (type == eShape::Circle) return make(CCircleDesc(p, R));
  // Sectors that wrap around, short ones, half circles, almost full and full ones.
  const float spans[] = {random.Uniform(1e-3f, 6.28f), random.Scale(-12, -1), g_fPi, 6.28f, 0.0f};
  const float a0 = random.Coin() ? random.Uniform(0.0f, 6.28f) : 0.0f;
  return make(Sided(CArcDesc(p, R, a0, a0 + spans[random.Below(5)]), sides));
}

CTrial RandomTrial(CRandom& random, eShape type, eSides sides, bool turns) {
  CTrial trial{RandomOutline(random, type, sides, turns), {}};
  const CRim rim = RandomRim(random, trial.m_cShape);
  const Vector2d u = Direction(random), across = Perp(u);
  CMotion& motion = trial.m_cMotion;
  motion.m_fRadius = Power(random, -3.0, -0.4);
  if (rim.m_fRadius > 0.0 && random.Below(4) == 0) // almost as large as the ring, or a bit larger
    motion.m_fRadius = rim.m_fRadius * (1.0 + SignedPower(random, -6.0, -1.0));
  const double r = motion.m_fRadius;
  const double inside = r < rim.m_fRadius && random.Coin() ? -1.0 : 1.0;
  const double contact = rim.m_fRadius + inside * r; // of the centres
  const double off = SignedPower(random, -7.0, -1.0);
  switch (random.Below(6)) {
  case 0: // grazes the rim, or misses it closely
    motion.m_vVel = Between(random, 0.5, 3.0) * u;
    motion.m_vPos = rim.m_vCenter + contact * (1.0 + off) * across - Between(random, 0.0, 1.5) * u;
    break;
  case 1: // touches, almost
    motion.m_vVel = r * Vector(random, -2.0, 4.0);
    motion.m_vPos = rim.m_vCenter + (contact + (random.Coin() ? 0.0 : off * r)) * u;
    break;
  case 2: // hardly beside the shape, or exactly at a centre
    motion.m_vVel = Vector(random, -0.3, 0.5);
    motion.m_vPos = trial.m_cShape.m_vCenter;
    if (type == eShape::LineSeg || random.Coin())
      motion.m_vPos = rim.m_vCenter + (rim.m_fRadius + off * r) * u;
    break;
  case 3: { // comes to the rim at a given place, such as an end
    const Vector2d way = Vector(random, -1.0, 0.3);
    motion.m_vPos = rim.m_vCenter + contact * u - way;
    motion.m_vVel = way * Between(random, 0.9, 2.0);
    break;
  }
  case 4: { // fast: over 10,000 radii
    motion.m_vPos = 2.0 * Direction(random);
    const Vector2d target = rim.m_vCenter + 0.5 * random.Unit() * u;
    motion.m_vVel = (target - motion.m_vPos) * Power(random, 0.0, 1.5);
    break;
  }
  default: { // anywhere
    const Vector2d from = random.InSquare(1.0f).cast<double>();
    motion.m_vPos = rim.m_vCenter + from;
    motion.m_vVel = r * Vector(random, -2.0, 3.0);
  }
  }
  motion.m_fDuration = 1.0;
  if (turns) { // up to two turns of the shape
    motion.m_fDuration = Between(random, 0.01, 0.2);
    motion.m_vVel *= Between(random, 0.0, 8.0);
  }
  return trial;
}

CTrial ClearTrial(CRandom& random, eShape type, eSides sides, bool turns, bool falls) {
  const auto inSquare = [&](double half) {
    const double x = Between(random, -half, half), y = Between(random, -half, half);
    return Vector2d(x, y);
  };
  for (;;) {
    CTrial trial{RandomOutline(random, type, sides, turns), {}};
    CMotion& motion = trial.m_cMotion;
    motion.m_fRadius = Between(random, 0.01, 0.5);
    motion.m_vPos = inSquare(2.0);
    const Vector2d target = inSquare(1.0);
    motion.m_vVel = (target - motion.m_vPos) * Between(random, falls ? 0.0 : 0.5, 3.0);
    motion.m_fDuration = 1.0;
    if (turns) {
      motion.m_fDuration = Between(random, 0.01, 0.2);
      motion.m_vVel *= Between(random, 0.0, 8.0);
    }
    if (falls) motion.m_vAcc = inSquare(turns ? 200.0 : 10.0);
    // A shape that turns about its own centre is no trial of a turn.
    const bool stays = turns && trial.m_cShape.m_vRotCenter == trial.m_cShape.m_vCenter;
    if (!stays && MakeOracle(trial.m_cShape, motion).Gap(0) > 1e-6L) return trial;
  }
}

std::string Name(const CTrials& trials) {
  const std::map<eShape, const char*> names{{eShape::Point, "Point"},
                                            {eShape::LineSeg, "LineSeg"},
                                            {eShape::Circle, "Circle"},
                                            {eShape::Arc, "Arc"}};
  return std::string(names.at(trials.m_eShapeType)) + (trials.m_bOneSided ? "OneSided" : "") +
         (trials.m_bTurns ? "Turning" : "") + (trials.m_bFalls ? "Falling" : "");
}

double GapBound(const CTrial& trial) {
  const CShapeGeometry& o = trial.m_cShape;
  const CMotion& motion = trial.m_cMotion;
  const double way = motion.m_vVel.norm() * motion.m_fDuration + 4.0 * motion.GetSagitta(),
               angle = std::abs(o.m_fTurnSpeed) * motion.m_fDuration;
  const double size =
      std::max(o.m_fSize, motion.m_vPos.cwiseAbs().maxCoeff() + o.m_fRadius) + motion.m_fRadius;
  return (o.m_fTurnSpeed == 0.0 ? 16.0 : g_nSweepRoundings + 16.0) * 0x1p-52 * (size + way) * (1.0 + angle);
}

bool OverlapsInside(const CTrial& trial) {
  CImpact impact;
  double depth;
  const CShapeGeometry& o = trial.m_cShape;
  if (o.m_eShapeType != eShape::Circle && o.m_eShapeType != eShape::Arc) return false;
  return Overlap(o, trial.m_cMotion, 0.0, impact, depth) &&
         impact.m_vNorm.dot(impact.m_vPOI - o.m_vCenter) < 0.0;
}

} // namespace Shapes::Geometry
