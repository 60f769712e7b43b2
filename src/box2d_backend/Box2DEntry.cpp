// SPDX-License-Identifier: MIT
#include "Box2DEntry.h"

#include "contact/PairSweep.h"
#include "world/OwnedEngine.h"

namespace Shapes::Box2D {

const CBackend::CEntry g_cEntry{"box2d", CollidePair, [](const CWorldDesc& desc) {
                                  return MakeWorld(desc, GetTuning(desc.m_cBox2D.m_eProfile));
                                }};

} // namespace Shapes::Box2D
