// SPDX-License-Identifier: MIT
#include "NativeBackend.h"

#include <Shapes/Contact.h>
#include <Shapes/DynamicCircle.h>

#include "Detect.h"
#include "NativeWorld.h"

namespace Shapes {
namespace Native {
namespace {

CBall ToBall(const CDynamicCircle& circle) {
  return {circle.GetPos(), circle.GetPrevPos(), circle.GetVel(), circle.GetRadius()};
}

class CNativeBackend final : public CBackend {
public:
  std::string_view GetName() const override { return "native"; }

  std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) const override {
    return std::make_unique<CNativeWorld>(desc);
  }

private:
  bool Detect(CContactDesc& c) const override {
    const CBall ball = ToBall(*c.m_pCircle);
    CHit hit;
    FailIf(!(c.m_pShape->GetMotionType() == eMotion::Dynamic
                 ? DetectBallBall(ToBall(static_cast<const CDynamicCircle&>(*c.m_pShape)), ball, hit)
                 : Native::Detect(*c.m_pShape, ball, hit)));
    c.m_vPOI = hit.m_vPOI;
    c.m_vNorm = hit.m_vNorm;
    c.m_fSetback = hit.m_fSetback;
    return true;
  }
};

} // namespace
} // namespace Native

const CBackend& GetNativeBackend() {
  static const Native::CNativeBackend backend;
  return backend;
}

} // namespace Shapes
