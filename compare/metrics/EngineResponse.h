// SPDX-License-Identifier: MIT
// Responses of an engine in its last step, read from the contacts that it reports.
#pragma once

#include <Shapes/World.h>

#include <cstddef>
#include <optional>

namespace Shapes::Compare {

/// Whether an event was a response: it changed the velocity or the position of a ball, also of one that lies.
/// Box2D also reports balls that leave, and sensors are reported by both.
bool IsResponse(const CContactEvent& event);

/// How many responses to balls that approached there were in the last step.
std::size_t CountBounces(const CWorld& world);

/// A response as one of its balls sees it.
struct CResponse {
  CShapeId m_cShape; ///< what was met; of two balls the other one
  Vector2 m_vPOI;    ///< as reported
  Vector2 m_vNorm;   ///< towards the ball that looks
};

/// The event as the ball sees it; none if it is no response or not one of this ball.
std::optional<CResponse> AsSeenBy(const CContactEvent& event, CShapeId ball);

} // namespace Shapes::Compare
