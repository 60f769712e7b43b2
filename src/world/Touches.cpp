// SPDX-License-Identifier: MIT
#include "Touches.h"

#include <Shapes/Limits.h>

#include "../Tolerances.h"
#include "BallPath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Shapes {
namespace {

// Whether the two of a solid pair are hardly apart now.
bool AreClose(const CWorldState& state, const CTouchingPair& pair, float reach) {
  FailIf(pair.m_cShape == CShapeId()); // nobody knows where that is
  const CBallArrays& b = state.m_cBalls;
  const std::size_t i = state.FindBall(pair.m_cBall), j = state.FindBall(pair.m_cShape);
  const Vector2d p = b.m_stdPos[i].cast<double>();
  double distance; // from the centre to the other one
  if (j != CWorldState::npos) {
    distance = (p - b.m_stdPos[j].cast<double>()).norm() - static_cast<double>(b.m_stdRadius[j]);
  } else {
    const CPathVertex here[] = {{0.0, p}, {1.0, p}};
    const CZone zone(*state.m_stdShapes[state.FindShape(pair.m_cShape)].m_pShape);
    distance = std::abs(zone.Approach(here).m_fDistance); // a solid circle is a ring
  }
  const float r = b.m_stdRadius[i];
  // A point is kept away by what rounds its place.
  const float rounding = g_fPointReach * b.m_stdPos[i].cwiseAbs().sum();
  return distance - static_cast<double>(r) <=
         static_cast<double>(std::max({reach, g_fTouchReach * r, rounding}));
}

} // namespace

CTouchEvent TouchEvent(const CTouchingPair& pair, bool begin) { return {pair.m_cShape, pair.m_cBall, begin}; }

void EndLost(const CWorldState& state, eMeeting meeting, std::vector<CTouchingPair>& touching,
             std::vector<CTouchEvent>& events) {
  std::erase_if(touching, [&](const CTouchingPair& pair) {
    FailIf(state.GetMeeting(pair) == meeting);
    events.push_back(TouchEvent(pair, false));
    return true;
  });
}

void FollowTouches(std::span<const CContactEvent> contacts, float reach, CWorldState& state,
                   std::vector<CTouchEvent>& events) {
  std::vector<CTouchingPair> met;
  for (const CContactEvent& contact : contacts)
    if (!contact.m_bIsSensor) met.push_back({contact.m_cBall, contact.m_cShape});
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());

  const std::vector<CTouchingPair> before = std::move(state.m_stdSolidTouching);
  std::vector<CTouchingPair> either;
  std::set_union(before.begin(), before.end(), met.begin(), met.end(), std::back_inserter(either));
  state.m_stdSolidTouching.clear();
  for (const CTouchingPair& pair : either) {
    const bool isMet = std::binary_search(met.begin(), met.end(), pair);
    const bool touched = std::binary_search(before.begin(), before.end(), pair);
    // A game may have destroyed one of them in the middle of the step.
    const bool touches = state.GetMeeting(pair) == eMeeting::Solid && (isMet || AreClose(state, pair, reach));
    if (touches) state.m_stdSolidTouching.push_back(pair);
    if (touches != touched) events.push_back(TouchEvent(pair, touches));
  }
}

} // namespace Shapes
