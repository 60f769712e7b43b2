// SPDX-License-Identifier: MIT
#include "Search.h"

namespace Shapes::Native {

template <class TLeg>
void SweepPointCircle(CSearch<TLeg>& search) {
  search.Meet(CRoundPart{search.GetShape().m_vCenter, 0.0});
}

SHAPES_SWEEP_FOR_ALL_LEGS(SweepPointCircle)

} // namespace Shapes::Native
