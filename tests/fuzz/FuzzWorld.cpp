// SPDX-License-Identifier: MIT
#include "../Descs.h"
#include "Bytes.h"
#include "WorldTrial.h"

namespace Shapes::Fuzz {
namespace {

// Bounds of time: thousands of sweeps take seconds where shapes turn hundreds of times in each.
constexpr std::size_t g_nMostShapes = 24;
constexpr std::uint64_t g_nMostEngineSteps = 150, g_nMostSweeps = 3000;
constexpr int g_nMostSteps = 24;

/// Worlds, shapes and values of any bytes.
class CByteSource : public CBytes {
public:
  using CBytes::CBytes;

  unsigned Below(unsigned n) { return Byte() % n; }
  Vector2 Pos() { return Vector(); }
  Vector2 Vel() { return Vector(); }
  Vector2 Gravity() { return Vector(); }
  float Angle() { return Number(); }
  float RotSpeed() { return Number(); }
  float Elasticity() { return Number(); }

  std::pair<eBackend, CWorldDesc> World() {
    static constexpr CEffectChoice choices[] = {g_cAutomatic, g_cApproximate, g_cContinuous};
    const unsigned kind = Byte() % 5;
    const bool isNative = kind < 3;
    CWorldDesc desc;
    if (isNative) desc.m_cEffects = choices[kind];
    desc.m_cBox2D.m_eProfile = kind == 4 ? eProfile::Tuned : eProfile::Shipped;
    desc.m_nSubsteps = 1u + Byte() % 3;
    const unsigned forced = Byte(), forbidden = Byte();
    for (unsigned e = 0; e < static_cast<unsigned>(eEffect::Size); ++e) {
      if ((forced >> e & 1) != 0) desc.m_cEffects.m_cForced.Set(static_cast<eEffect>(e));
      if ((forbidden >> e & 1) != 0) desc.m_cEffects.m_cForbidden.Set(static_cast<eEffect>(e));
    }
    // Mostly what is usual: then the rest of the bytes matters.
    const unsigned unusual = Byte();
    if ((unusual & 1) != 0) desc.m_fTimeStep = Number();
    if ((unusual & 2) != 0) desc.m_vGravity = Vector();
    if ((unusual & 4) != 0) desc.m_cBox2D.m_fLengthUnit = Number();
    if ((unusual & 8) != 0) desc.m_cBox2D.m_fSagittaTolerance = Number();
    if ((unusual & 16) != 0) desc.m_cBox2D.m_nVelocityIterations = Byte() % 32u;
    if ((unusual & 32) != 0) desc.m_cBox2D.m_nPositionIterations = Byte() % 32u;
    return {isNative ? eBackend::Native : eBackend::Box2D, desc};
  }

  /// A point, a segment, a circle, an arc, or a ball.
  CAnyShapeDesc Shape(unsigned what) {
    if (what == 4) return Ball();
    if (what == 0) return Moving(CPointDesc(Vector()));
    if (what == 1) {
      const Vector2 p0 = Vector(), p1 = Vector();
      return Moving(Sided(CLineSegDesc(p0, p1), Sides()));
    }
    const Vector2 p = Vector();
    const float r = Number();
    if (what == 2) return Moving(CCircleDesc(p, r));
    const float a0 = Number(), a1 = Number();
    return Moving(Sided(CArcDesc(p, r, a0, a1), Sides()));
  }

  /// Of a compound.
  std::vector<CAnyShapeDesc> Parts() {
    std::vector<CAnyShapeDesc> parts;
    for (unsigned n = 1u + Byte() % 3; n > 0; --n)
      parts.push_back(Shape(Byte() % 4));
    return parts;
  }

private:
  template <class TDesc>
  TDesc Moving(TDesc desc) {
    const unsigned flags = Byte();
    desc.m_bIsSensor = (flags & 7) == 7;
    if ((flags & 16) != 0) desc.m_fElasticity = Number();
    if ((flags & 8) == 0) return desc;
    const float revsPerSecond = Number();
    return Turning(desc, revsPerSecond, Vector());
  }
  eSides Sides() { return OneOf({eSides::Both, eSides::Front, eSides::Back}); }

  CDynamicCircleDesc Ball() {
    const Vector2 p = Vector(), v = Vector();
    const float r = Number();
    CDynamicCircleDesc desc(p, r, v);
    const unsigned flags = Byte();
    desc.m_bIsSensor = (flags & 7) == 7;
    if ((flags & 8) != 0) desc.m_fMass = Number();
    if ((flags & 16) != 0) desc.m_fElasticity = Number();
    return desc;
  }
};

bool IsLong(const CWorldTrial<CByteSource>& trial) {
  const CWorldStats& stats = trial.GetWorld().GetStats();
  return trial.GetSteps() >= g_nMostSteps || stats.m_nEngineSteps > g_nMostEngineSteps ||
         stats.m_nSweeps > g_nMostSweeps;
}

} // namespace

void FuzzWorld(std::span<const std::uint8_t> bytes) {
  CByteSource source(bytes);
  CWorldTrial trial(source);
  const auto [backend, desc] = source.World();
  if (!trial.Make(*GetBackend(backend), desc)) return;
  while (!source.IsEmpty() && !IsLong(trial))
    if (const unsigned operation = source.Below(g_nOperations);
        operation > 5 || trial.CountShapes() < g_nMostShapes)
      trial.Do(operation);
  if (!IsLong(trial)) trial.Step();
}

} // namespace Shapes::Fuzz
