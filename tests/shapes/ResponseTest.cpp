// SPDX-License-Identifier: MIT
#include "shapes/Response.h"

#include "../Testing.h"

#include "Tolerances.h"

namespace Shapes {
namespace {

const Vector2 g_vUp(0.0f, 1.0f);

TEST(KinematicResponse, OfASurfaceFasterThanAnyBallStaysFinite) {
  // With the largest elasticities. Infinity times the component of n that is 0 would not be a number.
  const float e = g_fMaxElasticity * g_fMaxElasticity;
  for (const float V : {1e18f, 1e25f, 1e30f, 1e38f}) {
    Vector2 p = Vector2::Zero(), v(3, -4);
    RespondKinematic<Vector2>(Vector2(0, 1), 0.0f, e, Vector2(0, V), p, v);
    EXPECT_EQ(v.x(), 3.0f) << V;
    EXPECT_GT(v.y(), g_fMaxSpeed) << V;
    EXPECT_TRUE(std::isfinite(v.y())) << V;
  }
}

// One of speed 1 meets one at rest.
TEST(DynamicResponse, OfExtremeMassesIsRight) {
  EXPECT_TRUE(std::isinf(1e30f * 1e30f)); // their product
  struct CRow {
    float m_fMass0, m_fMass1;
    double m_fVel0, m_fVel1; // after
  };
  for (const CRow& row : {CRow{1e-12f, 1, -1.999999999998, -1}, CRow{1e30f, 1e30f, -1, 0},
                          CRow{g_fMaxMass, g_fMaxMass, -1, 0}}) {
    Vector2 p0(0, 0), p1(0, 0), v0(0, 0), v1(0, -1);
    RespondDynamic(g_vUp, 0.0f, 1.0f, row.m_fMass0, row.m_fMass1, p0, v0, p1, v1);
    EXPECT_NEAR(v0.y(), row.m_fVel0, row.m_fMass0 == g_fMaxMass ? 0 : 4 * g_fUlp) << row.m_fMass0;
    EXPECT_NEAR(v1.y(), row.m_fVel1, 4 * g_fUlp) << row.m_fMass0;
  }
}

} // namespace
} // namespace Shapes
