// SPDX-License-Identifier: MIT
// The one file that knows both engines.
#include <Shapes/Backend.h>

#include <Shapes/Contact.h>
#include <Shapes/DynamicCircle.h>
#include <Shapes/World.h>

#include "native/NativeBackend.h"
#include "shapes/Response.h"
#include "shapes/Validate.h"

#ifdef SHAPES_WITH_BOX2D
#include "box2d_backend/Box2DBackend.h"
#endif

namespace Shapes {

const CBackend* GetBackend(eBackend e) {
  switch (e) {
  case eBackend::Native: return &GetNativeBackend();
  case eBackend::Box2D:
#ifdef SHAPES_WITH_BOX2D
    return &GetBox2DBackend();
#else
    return nullptr;
#endif
  }
  return nullptr;
}

const CBackend& GetDefaultBackend() { return *GetBackend(eBackend::SHAPES_DEFAULT_BACKEND); }

std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) { return GetDefaultBackend().MakeWorld(desc); }

bool CBackend::CollisionDetected(CContactDesc& c) const {
  if (c.m_pShape == nullptr) Refuse("c.m_pShape", "null", "a shape");
  if (c.m_pCircle == nullptr) Refuse("c.m_pCircle", "null", "a ball");
  FailIf(c.m_pShape == c.m_pCircle);
  FailIf(!c.m_pShape->GetCanCollide() || !c.m_pCircle->GetCanCollide());
  FailIf(!Detect(c));
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
