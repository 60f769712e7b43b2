// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {

template <class TMotion>
void ImpactPointCircle(CImpactSearch<TMotion>& search) {
  search.KeepEarliest(CDisk{search.GetShape().m_vCenter, 0.0});
}

SHAPES_IMPACTS_FOR_ALL_MOTIONS(ImpactPointCircle)

} // namespace Shapes::Geometry
