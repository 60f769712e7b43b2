// SPDX-License-Identifier: MIT
// Balls for the pair kernels, and what their answers are held against.
#pragma once

#include "Inputs.h"
#include "Worst.h"

#include "native/narrowphase/Collide.h"

namespace Shapes::Bounds {

using Native::CBall;
using Native::CHit;

/// A gap between a centre and a shape for a ball of radius r: any, almost touching, or almost none.
inline float AnyGap(CRandom& random, float r) {
  switch (random.Below(4)) {
  case 0: return r * NearOne(random);
  case 1: return r * random.Scale(-30, -1);
  default: return r * random.Uniform(0.0f, 1.3f);
  }
}

/// A ball that has not moved in this step, of any velocity.
inline CBall Resting(CRandom& random, const Vector2& p, float r) {
  return {p, p, AnyWay(random, AnySize(random)), r};
}

/// The errors of one kernel.
struct CHitErrors {
  explicit CHitErrors(const std::string& name)
      : m_cAnswer(name + ", answer"),
        m_cPOI(name + ", POI"),
        m_cNorm(name + ", normal"),
        m_cSetback(name + ", setback") {}

  /// A wrong answer is an error of as much as the gap is off the one at which the answer changes.
  void SeeAnswer(bool is, const CFifty& overlap, const CFifty& bound) {
    m_cAnswer.See(is == (overlap > 0) ? CFifty(0) : CFifty(abs(overlap)), bound);
  }
  void ExpectKept(int least) const {
    for (const CWorst* pWorst : {&m_cAnswer, &m_cPOI, &m_cNorm, &m_cSetback})
      pWorst->ExpectKept(least);
  }

  CWorst m_cAnswer, m_cPOI, m_cNorm, m_cSetback;
};

} // namespace Shapes::Bounds
