// SPDX-License-Identifier: MIT
// From a descriptor to the classes of its shape: a new shape is a row here.
#include <Shapes/WorldDesc.h>

#include "Validate.h"

namespace Shapes {
namespace {

template <class TStatic, class TKinematic, class TDesc>
std::unique_ptr<CShape> Make(const TDesc& desc) {
  if (desc.m_eMotionType == eMotion::Static) return std::make_unique<TStatic>(desc);
  if (desc.m_eMotionType == eMotion::Kinematic) return std::make_unique<TKinematic>(desc);
  Refuse("m_eMotionType", "neither static nor kinematic",
         "Static or Kinematic; balls are made from CDynamicCircleDesc");
}

// A descriptor without a function of its own does not compile, even where one for its base would take it.
struct CMaker {
  using CMade = std::unique_ptr<CShape>;
  CMade operator()(const CPointDesc& desc) const { return Make<CPoint, CKinematicPoint>(desc); }
  CMade operator()(const CLineSegDesc& desc) const { return Make<CLineSeg, CKinematicLineSeg>(desc); }
  CMade operator()(const CCircleDesc& desc) const { return Make<CCircle, CKinematicCircle>(desc); }
  CMade operator()(const CArcDesc& desc) const { return Make<CArc, CKinematicArc>(desc); }
  CMade operator()(const CDynamicCircleDesc& desc) const { return std::make_unique<CDynamicCircle>(desc); }
  template <class TDesc>
  CMade operator()(const TDesc&) const = delete;
};

} // namespace

std::unique_ptr<CShape> MakeShape(const CAnyShapeDesc& desc) { return std::visit(CMaker(), desc); }

} // namespace Shapes
