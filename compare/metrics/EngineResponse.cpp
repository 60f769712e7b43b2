// SPDX-License-Identifier: MIT
#include "EngineResponse.h"

#include <algorithm>

namespace Shapes::Compare {
namespace {

bool IsBounce(const CContactEvent& event) {
  return !event.m_bIsSensor && (event.m_fSpeed > 0.0f || event.m_fSetback > 0.0f);
}

} // namespace

bool IsResponse(const CContactEvent& event) {
  return IsBounce(event) || (!event.m_bIsSensor && event.m_fImpulse > 0.0f);
}

std::size_t CountBounces(const CWorld& world) {
  const auto contacts = world.GetContacts();
  return static_cast<std::size_t>(std::count_if(contacts.begin(), contacts.end(), IsBounce));
}

std::optional<CResponse> AsSeenBy(const CContactEvent& event, CShapeId ball) {
  if (!IsResponse(event)) return std::nullopt;
  if (event.m_cBall == ball) return CResponse{event.m_cShape, event.m_vPOI, event.m_vNorm};
  if (event.m_cShape == ball) return CResponse{event.m_cBall, event.m_vPOI, -event.m_vNorm};
  return std::nullopt;
}

} // namespace Shapes::Compare
