// SPDX-License-Identifier: MIT
// The table of engines: the one file that knows them all. A new engine is a row here and a folder.
#include <Shapes/Backend.h>

#include <Shapes/Contact.h>
#include <Shapes/DynamicCircle.h>
#include <Shapes/World.h>

#include "shapes/Response.h"
#include "shapes/Validate.h"
#include "world/Engine.h"

namespace Shapes {

// At the end of NativeEngine.cpp and OwnedEngine.cpp.
namespace Native {
extern const CBackend::CEntry g_cEntry;
}
namespace Box2D {
extern const CBackend::CEntry g_cEntry;
}

namespace {

constexpr CBackend g_stdBackends[] = {
    CBackend(Native::g_cEntry),
#ifdef SHAPES_WITH_BOX2D
    CBackend(Box2D::g_cEntry),
#endif
};

} // namespace

std::span<const CBackend> GetBackends() { return g_stdBackends; }

const CBackend* GetBackend(std::string_view name) {
  for (const CBackend& backend : g_stdBackends)
    if (backend.GetName() == name) return &backend;
  return nullptr;
}

const CBackend* GetBackend(eBackend e) {
  switch (e) {
  case eBackend::Native: return GetBackend("native");
  case eBackend::Box2D: return GetBackend("box2d");
  }
  return nullptr;
}

const CBackend& GetDefaultBackend() {
  static const CBackend& backend = *GetBackend(SHAPES_DEFAULT_BACKEND);
  return backend;
}

std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) { return GetDefaultBackend().MakeWorld(desc); }

std::string_view CBackend::GetName() const { return m_cEntry.m_sName; }

std::unique_ptr<CWorld> CBackend::MakeWorld(const CWorldDesc& desc) const {
  return m_cEntry.m_pMakeWorld(desc);
}

bool CBackend::CollisionDetected(CContactDesc& c) const {
  if (c.m_pShape == nullptr) Refuse("c.m_pShape", "null", "a shape");
  if (c.m_pCircle == nullptr) Refuse("c.m_pCircle", "null", "a ball");
  FailIf(c.m_pShape == c.m_pCircle);
  FailIf(!c.m_pShape->GetCanCollide() || !c.m_pCircle->GetCanCollide());
  FailIf(!DoMeet(c.m_pShape->GetFilter(), c.m_pCircle->GetFilter()));
  FailIf(!m_cEntry.m_pCollide(c));
  const Vector2 surface = c.m_pShape->GetMotionType() == eMotion::Dynamic
                              ? static_cast<const CDynamicCircle&>(*c.m_pShape).GetVel()
                              : c.m_pShape->GetSurfaceVelocity(c.m_vPOI);
  c.m_fSpeed = ApproachSpeed(c.m_pCircle->GetVel(), surface, c.m_vNorm);
  return true;
}

bool CShape::CollisionDetected(CContactDesc& c) {
  if (c.m_pCircle == nullptr) Refuse("c.m_pCircle", "null", "a ball");
  c.m_pShape = this;
  return GetDefaultBackend().CollisionDetected(c);
}

} // namespace Shapes
