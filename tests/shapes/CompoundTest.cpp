// SPDX-License-Identifier: MIT
#include "../Testing.h"

namespace Shapes {
namespace {

class Compound : public ::testing::Test {
protected:
  Compound() {
    for (CShape* pShape : {static_cast<CShape*>(&m_cPoint), static_cast<CShape*>(&m_cSeg),
                           static_cast<CShape*>(&m_cCircle), static_cast<CShape*>(&m_cArc)})
      m_cCompound.AddShape(pShape);
  }
  CKinematicPoint m_cPoint{CPointDesc({1.0f, 0.0f})};
  CKinematicLineSeg m_cSeg{CLineSegDesc({1.0f, 0.0f}, {3.0f, 0.0f})};
  CKinematicCircle m_cCircle{CCircleDesc({2.0f, 0.0f}, 0.5f)};
  CKinematicArc m_cArc{CArcDesc({2.0f, 0.0f}, 1.0f, 0.0f, 1.0f)};
  CCompoundShape m_cCompound;
};

TEST_F(Compound, TurnsAllShapesAboutOneCentre) {
  for (int i = 0; i < 2; ++i) { // from the poses at construction: the same twice
    m_cCompound.Rotate({1.0f, 0.0f}, g_fPi / 2);
    EXPECT_LE((m_cPoint.GetPos() - Vector2(1.0f, 0.0f)).norm(), 8 * g_fUlp);
    EXPECT_NEAR(m_cSeg.GetAABB().GetTopLeft().y(), 2.0f, 16 * g_fUlp); // upright: either end may be the first
    EXPECT_NEAR(m_cSeg.GetAABB().GetWidth(), 0.0f, 16 * g_fUlp);
    EXPECT_LE((m_cCircle.GetPos() - Vector2(1.0f, 1.0f)).norm(), 8 * g_fUlp);
    EXPECT_LE((m_cArc.GetEndPt0() - Vector2(1.0f, 2.0f)).norm(), 16 * g_fUlp);
    EXPECT_EQ(m_cCompound.GetOrientation(), m_cSeg.GetOrientation());
    EXPECT_NEAR(m_cCompound.GetOrientation(), g_fPi / 2, g_fUlp);
  }
}

TEST_F(Compound, ResetPutsAllBack) {
  m_cCompound.Rotate({5.0f, 2.0f}, 1.3f);
  m_cCompound.Reset();
  EXPECT_EQ(m_cCompound.GetOrientation(), 0.0f);
  EXPECT_EQ(m_cPoint.GetPos(), Vector2(1.0f, 0.0f));
  EXPECT_EQ(m_cSeg.GetEndPt1(), Vector2(3.0f, 0.0f));
  EXPECT_EQ(m_cCircle.GetPos(), Vector2(2.0f, 0.0f));
  EXPECT_EQ(m_cArc.GetPos(), Vector2(2.0f, 0.0f));
  EXPECT_EQ(m_cArc.GetEndPt0(), Vector2(3.0f, 0.0f));
}

TEST_F(Compound, SpeedAndCentreGoToEveryShape) {
  m_cCompound.SetRotSpeed(0.25f);
  m_cCompound.SetRotCenter({1.0f, 0.0f});
  EXPECT_EQ(m_cCompound.GetRotSpeed(), 0.25f);
  EXPECT_EQ(m_cCompound.GetRotCenter(), Vector2(1.0f, 0.0f));
  for (const CShape* pShape : m_cCompound.GetShapes()) {
    EXPECT_EQ(pShape->GetRotSpeed(), 0.25f);
    EXPECT_EQ(pShape->GetRotCenter(), Vector2(1.0f, 0.0f));
    EXPECT_TRUE(pShape->GetRotating());
  }
}

TEST_F(Compound, MoveTurnsAllByOneStepAndKeepsThemTogether) {
  m_cCompound.SetRotSpeed(0.25f);
  m_cCompound.SetRotCenter({1.0f, 0.0f});
  for (int i = 0; i < 60; ++i) { // a second, a quarter turn
    m_cCompound.move();
    EXPECT_EQ(m_cCompound.GetOrientation(), m_cSeg.GetOrientation());
    EXPECT_EQ(m_cCompound.GetOrientation(), m_cCircle.GetOrientation());
  }
  EXPECT_NEAR(m_cCompound.GetOrientation(), g_fPi / 2, 60 * g_fUlp); // one rounding a step
  EXPECT_LE((m_cCircle.GetPos() - Vector2(1.0f, 1.0f)).norm(), 60 * g_fUlp + 8 * g_fUlp);
}

TEST_F(Compound, SetOrientationTurnsAboutItsCentre) {
  m_cCompound.SetRotCenter({1.0f, 0.0f});
  m_cCompound.SetOrientation(g_fPi);
  EXPECT_LE((m_cCircle.GetPos() - Vector2(0.0f, 0.0f)).norm(), 8 * g_fUlp);
}

TEST_F(Compound, AShapeThatIsAddedLaterJoinsThePose) {
  m_cCompound.SetRotCenter({1.0f, 0.0f});
  m_cCompound.SetRotSpeed(2.0f);
  m_cCompound.SetOrientation(g_fPi / 2);
  CKinematicPoint late(CPointDesc({3.0f, 0.0f}));
  m_cCompound.AddShape(&late);
  EXPECT_EQ(late.GetRotSpeed(), 2.0f);
  EXPECT_EQ(late.GetOrientation(), m_cCompound.GetOrientation());
  EXPECT_LE((late.GetPos() - Vector2(1.0f, 2.0f)).norm(), 16 * g_fUlp);
}

TEST_F(Compound, AShapeThatWasTurnedBeforeItIsAddedJoinsThePoseToo) {
  CKinematicPoint turned(CPointDesc({3.0f, 0.0f}));
  turned.Rotate({0.0f, 0.0f}, 1.0f);
  m_cCompound.AddShape(&turned);
  EXPECT_EQ(turned.GetOrientation(), m_cCompound.GetOrientation());
  EXPECT_EQ(turned.GetPos(), Vector2(3.0f, 0.0f));
}

TEST_F(Compound, PointsToItsShapesOnly) {
  EXPECT_EQ(m_cCompound.GetShapes().size(), 4u);
  EXPECT_EQ(m_cCompound.GetShapes()[1], &m_cSeg);
  const CCompoundShape copy = m_cCompound;
  EXPECT_EQ(copy.GetShapes()[1], &m_cSeg);
}

TEST_F(Compound, BadValuesAreRefusedAndChangeNothing) {
  EXPECT_THROW(m_cCompound.AddShape(nullptr), std::invalid_argument);
  EXPECT_THROW(m_cCompound.SetRotSpeed(g_fNan), std::invalid_argument);
  EXPECT_THROW(m_cCompound.SetRotCenter({0.0f, g_fNan}), std::invalid_argument);
  EXPECT_THROW(m_cCompound.Rotate({0.0f, g_fNan}, 1.0f), std::invalid_argument);
  EXPECT_THROW(m_cCompound.Rotate({0.0f, 0.0f}, g_fNan), std::invalid_argument);
  EXPECT_EQ(m_cCompound.GetShapes().size(), 4u);
  EXPECT_EQ(m_cCompound.GetRotSpeed(), 0.0f);
  EXPECT_EQ(m_cCompound.GetOrientation(), 0.0f);
  EXPECT_EQ(m_cCircle.GetPos(), Vector2(2.0f, 0.0f));
}

} // namespace
} // namespace Shapes
