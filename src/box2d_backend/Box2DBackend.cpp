// SPDX-License-Identifier: MIT
#include "Box2DBackend.h"

#include "OwnedWorld.h"
#include "PairSweep.h"

namespace Shapes {
namespace Box2D {
namespace {

class CBox2DBackend final : public CBackend {
public:
  std::string_view GetName() const override { return "box2d"; }

  std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) const override {
    return std::make_unique<COwnedWorld>(desc);
  }

private:
  bool Detect(CContactDesc& c) const override { return DetectPair(c); }
};

} // namespace
} // namespace Box2D

const CBackend& GetBox2DBackend() {
  static const Box2D::CBox2DBackend backend;
  return backend;
}

} // namespace Shapes
