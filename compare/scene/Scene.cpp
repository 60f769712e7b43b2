// SPDX-License-Identifier: MIT
#include "Scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace Shapes::Compare {

const CShapeDesc& GetBase(const CAnyShapeDesc& any) {
  return std::visit([](const auto& desc) -> const CShapeDesc& { return desc; }, any);
}

bool Travels(const CSceneShape& shape) {
  return shape.m_cShuttle || !GetBase(shape.m_cDesc).m_vVel.isZero(0.0f);
}

bool Moves(const CSceneShape& shape) { return Turns(shape) || Travels(shape); }

bool Turns(const CSceneShape& shape) { return shape.m_cFlip || GetBase(shape.m_cDesc).m_fRotSpeed != 0.0f; }

std::vector<CAnyShapeDesc> GetShapes(const CScene& scene) {
  std::vector<CAnyShapeDesc> shapes;
  for (const CSceneShape& shape : scene.m_stdShapes)
    shapes.push_back(shape.m_cDesc);
  return shapes;
}

namespace {

// How far from rest something is that goes to `end` and back once in a period, at least 0.
double GoAndComeBack(double end, double speed, double period, double t) {
  const double half = 0.5 * period;
  double u = std::fmod(t, period);
  if (u < 0.0) u += period;
  const double gone = std::min(speed * (u < half ? u : u - half), end);
  return u < half ? gone : end - gone;
}

} // namespace

float FlipOrientation(const CFlip& flip, double t) {
  const double angle = flip.m_fAngle, speed = 2.0 * std::numbers::pi * flip.m_fSpeed;
  return static_cast<float>(
      std::copysign(GoAndComeBack(std::abs(angle), speed, flip.m_fPeriod, t + flip.m_fPhase), angle));
}

Eigen::Vector2d ShuttleOffset(const CShuttle& shuttle, double t) {
  const Eigen::Vector2d way = shuttle.m_vWay.cast<double>();
  const double length = way.norm();
  if (length == 0.0) return way;
  return GoAndComeBack(length, shuttle.m_fSpeed, shuttle.m_fPeriod, t + shuttle.m_fPhase) / length * way;
}

} // namespace Shapes::Compare
