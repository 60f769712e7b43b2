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

// Bit for bit. Its own orientation, speed and centre are those of its shapes.
TEST_F(Compound, DoesToEachShapeWhatTheShapeDoesAlone) {
  std::vector<std::unique_ptr<CShape>> alone;
  for (const CShape* pShape : m_cCompound.GetShapes())
    alone.push_back(pShape->Clone());
  const auto expectSame = [&](const char* what, const auto& act) {
    SCOPED_TRACE(what);
    act(m_cCompound);
    for (std::size_t i = 0; i < alone.size(); ++i) {
      CShape &part = *m_cCompound.GetShapes()[i], &same = *alone[i];
      act(same);
      EXPECT_EQ(part.GetPos(), same.GetPos());
      EXPECT_EQ(part.GetAABB().GetTopLeft(), same.GetAABB().GetTopLeft());
      EXPECT_EQ(part.GetAABB().GetBottomRt(), same.GetAABB().GetBottomRt());
      EXPECT_EQ(part.GetVel(), same.GetVel());
      EXPECT_EQ(part.GetOrientation(), same.GetOrientation());
      EXPECT_EQ(m_cCompound.GetOrientation(), same.GetOrientation());
      EXPECT_EQ(m_cCompound.GetRotSpeed(), same.GetRotSpeed());
      EXPECT_EQ(m_cCompound.GetRotCenter(), same.GetRotCenter());
    }
  };
  expectSame("Rotate", [](auto& shape) { shape.Rotate({1.0f, 0.0f}, g_fPi / 2); });
  expectSame("Rotate again", [](auto& shape) { shape.Rotate({5.0f, 2.0f}, 1.3f); });
  expectSame("SetRotCenter", [](auto& shape) { shape.SetRotCenter({1.0f, 0.0f}); });
  expectSame("SetOrientation", [](auto& shape) { shape.SetOrientation(g_fPi); });
  expectSame("SetRotSpeed", [](auto& shape) { shape.SetRotSpeed(0.25f); });
  for (int i = 0; i < 60; ++i)
    expectSame("move", [](auto& shape) { shape.move(); });
  expectSame("SetVel", [](auto& shape) { shape.SetVel({0.5f, -3.0f}); });
  for (int i = 0; i < 60; ++i)
    expectSame("move along", [](auto& shape) { shape.move(); });
  EXPECT_NEAR(m_cCompound.GetRotCenter().x(), 1.5f, 1e-5f);
  expectSame("Reset", [](auto& shape) { shape.Reset(); });
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
