// SPDX-License-Identifier: MIT
#include "Effects.h"

#include "../shapes/Validate.h"

namespace Shapes {
namespace {

constexpr std::size_t CContent::*g_pCounts[] = {&CContent::m_nBalls,       &CContent::m_nSolidBalls,
                                                &CContent::m_nSolidShapes, &CContent::m_nMoving,
                                                &CContent::m_nSensors,     &CContent::m_nWithStops};

std::string Plural(std::size_t n, const std::string& one, const std::string& more) {
  return std::to_string(n) + " " + (n == 1 ? one : more);
}

std::string Why(eEffect e, const CContent& c, const CWorldState& state) {
  const auto whatCanMeet = [&] {
    return Plural(c.m_nSolidBalls, "solid ball", "solid balls") + ", " +
           Plural(c.m_nSolidShapes, "solid shape", "solid shapes");
  };
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
  case eEffect::Events: return whatCanMeet() + ", " + Plural(c.m_nSensors, "sensor", "sensors");
  case eEffect::Continuous: return whatCanMeet() + ", gravity is " + ToText(state.m_vGravity);
  case eEffect::Touches: return Plural(state.m_stdSolidTouching.size(), "pair touches", "pairs touch");
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
  case eEffect::Touches: return "Touches";
  case eEffect::Size: break;
  }
  return {};
}

CContent CContent::Of(const CShapeEntry& entry) {
  const CShape& shape = *entry.m_pShape;
  CContent c;
  c.m_nMoving =
      shape.GetMotionType() == eMotion::Kinematic &&
      (entry.m_bIsHeld ? entry.m_fRotSpeed != 0.0f || entry.m_vVel != Vector2::Zero() : shape.GetMoving());
  c.m_nWithStops = entry.HasStops();
  c.m_nSensors = shape.GetSensor();
  c.m_nSolidShapes = IsSolid(shape);
  return c;
}

CContent CContent::Of(const CBallArrays& balls, std::size_t i) {
  CContent c;
  c.m_nBalls = 1;
  c.m_nSolidBalls = balls.IsSolid(i);
  c.m_nSensors = balls.m_stdSensor[i] != 0;
  return c;
}

void CContent::Replace(const CContent& before, const CContent& after) {
  for (std::size_t CContent::*const count : g_pCounts)
    this->*count += after.*count - before.*count;
}

CContent CountContent(const CWorldState& state) {
  CContent c;
  for (std::size_t i = 0; i < state.m_cBalls.Size(); ++i)
    c.Replace({}, CContent::Of(state.m_cBalls, i));
  for (const CShapeEntry& entry : state.m_stdShapes)
    c.Replace({}, CContent::Of(entry));
  return c;
}

CEffects GetCalledFor(const CContent& c, const CWorldState& state) {
  CEffects called;
  called.Set(eEffect::Gravity, c.m_nBalls > 0 && state.m_vGravity != Vector2::Zero());
  called.Set(eEffect::Kinematics, c.m_nMoving > 0);
  called.Set(eEffect::BallPairs, c.m_nSolidBalls > 1);
  called.Set(eEffect::Sensors, c.m_nSensors > 0 || !state.m_stdTouching.empty());
  called.Set(eEffect::Events, c.CanMeet() || called.Has(eEffect::Sensors));
  called.Set(eEffect::Continuous, c.CanMeet() || called.Has(eEffect::Gravity));
  return called;
}

std::string Explain(CEffects running, const CEffectChoice& choice, CEffects engineNeeds, CEffects byHost,
                    const CContent& c, const CWorldState& state) {
  std::string text;
  for (int i = 0; i < static_cast<int>(eEffect::Size); ++i) {
    const auto e = static_cast<eEffect>(i);
    text += GetName(e);
    text += running.Has(e) ? ": runs" : ": does not run";
    if (choice.m_cForced.Has(e))
      text += ", forced by the description";
    else if (choice.m_cForbidden.Has(e))
      text += ", forbidden by the description";
    else if (byHost.Has(e))
      text += ", decided by the world around";
    else if (engineNeeds.Has(e))
      text += ", as always in this engine";
    text += "; " + Why(e, c, state) + "\n";
  }
  return text;
}

} // namespace Shapes
