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
  CTwo m_vNormX{}, m_vNormY{};          ///< of each row, as all that follows
  CTwo m_vInverse{}, m_vOtherInverse{}; ///< masses
  CTwo m_vShare{};                      ///< 1 / (sum of the inverse masses)
  CTwo m_vLeast{};                      ///< that the difference of velocities may be at the end
  CTwo m_vImpulse{}, m_vBefore{};       ///< after the last round, and after the one before
  std::uint32_t m_nBall[2]{}, m_nOther[2]{};

  /// @param pVels  of all balls
  /// @returns along the normal
  CTwo GetDifference(const CTwo* pVels) const {
    const CTwo a = pVels[m_nBall[0]] - pVels[m_nOther[0]], b = pVels[m_nBall[1]] - pVels[m_nOther[1]];
    return m_vNormX * CTwo{a[0], b[0]} + m_vNormY * CTwo{a[1], b[1]};
  }
  void Push(CTwo impulse, CTwo* pVels) const {
    const CTwo ball = impulse * m_vInverse, ballX = ball * m_vNormX, ballY = ball * m_vNormY;
    const CTwo other = impulse * m_vOtherInverse, otherX = other * m_vNormX, otherY = other * m_vNormY;
    for (int which = 0; which < 2; ++which) {
      pVels[m_nBall[which]] += CTwo{ballX[which], ballY[which]};
      pVels[m_nOther[which]] -= CTwo{otherX[which], otherY[which]};
    }
  }
};

} // namespace Shapes::Native
