// SPDX-License-Identifier: MIT
// Two contacts of a pile that are solved at once.
#pragma once

#include "../../geometry/Vector.h"

#include <cstdint>
#include <vector>

namespace Shapes::Native {

/// Two numbers with which the processor calculates at once. Each has the bits that it would have alone.
using CTwo = double __attribute__((vector_size(16), may_alias));
static_assert(sizeof(CTwo) == sizeof(Vector2d) && alignof(CTwo) == alignof(Vector2d));

/// Each vector as its x and y.
inline CTwo* GetTwos(std::vector<Vector2d>& vectors) { return reinterpret_cast<CTwo*>(vectors.data()); }

inline CTwo Min(CTwo a, CTwo b) { return a < b ? a : b; }
inline CTwo Max(CTwo a, CTwo b) { return a > b ? a : b; }

/// Two rows of CContactSolver that share no ball, so that neither sees what the other one changes. A row of
/// zeros, of a shape and itself, does nothing.
struct CRowPair {
  CTwo m_vLackX{}, m_vLackY{};    ///< of each row, as all that follows: normal / sum of the inverse masses
  CTwo m_vLeast{};                ///< that the difference of velocities may be at the end / the same sum
  CTwo m_vBallX{}, m_vBallY{};    ///< normal * inverse mass of the ball
  CTwo m_vOtherX{}, m_vOtherY{};  ///< and of the other one
  CTwo m_vInverse{};              ///< the sum of the inverse masses
  CTwo m_vImpulse{}, m_vBefore{}; ///< after the last round, and after the one before
  std::uint32_t m_nBall[2]{}, m_nOther[2]{};

  /// Gives each row what it lacks. A row waits for those before it that change its balls: all that does not
  /// depend on these is calculated meanwhile.
  /// @param part   of what it lacks
  /// @param now    the impulses, of which none may become negative: no contact pulls
  /// @param pVels  of all balls
  /// @returns by how much the impulses change
  CTwo Relax(double part, CTwo now, CTwo* pVels) const {
    const CTwo ball0 = pVels[m_nBall[0]], ball1 = pVels[m_nBall[1]];
    const CTwo other0 = pVels[m_nOther[0]], other1 = pVels[m_nOther[1]];
    const CTwo d0 = ball0 - other0, d1 = ball1 - other1;
    const CTwo has = part * m_vLackX * CTwo{d0[0], d1[0]} + part * m_vLackY * CTwo{d0[1], d1[1]};
    // Without a branch, as it cannot be foreseen which rows change.
    const CTwo more = Max(part * m_vLeast - has, -now);
    const CTwo ballX = more * m_vBallX, ballY = more * m_vBallY;
    const CTwo otherX = more * m_vOtherX, otherY = more * m_vOtherY;
    pVels[m_nBall[0]] = ball0 + CTwo{ballX[0], ballY[0]};
    pVels[m_nBall[1]] = ball1 + CTwo{ballX[1], ballY[1]};
    pVels[m_nOther[0]] = other0 - CTwo{otherX[0], otherY[0]};
    pVels[m_nOther[1]] = other1 - CTwo{otherX[1], otherY[1]};
    return more;
  }
};

} // namespace Shapes::Native
