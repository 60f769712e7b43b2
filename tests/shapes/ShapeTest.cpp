// SPDX-License-Identifier: MIT
// The members that all shapes share, tried on each kind.

#include <numbers>
#include <typeinfo>

#include "../Testing.h"

namespace Shapes {
namespace {

struct CKind {
  const char* m_sName;
  CAnyShapeDesc m_cDesc;
  eShape m_eType;
  const std::type_info& m_cClass;
};

// Half a revolution a second about (1, 0), as far as it is kinematic.
template <class TDesc>
TDesc Turned(TDesc desc, eMotion motion) {
  desc = Turning(desc, 0.5f, {1.0f, 0.0f});
  desc.m_eMotionType = motion;
  return desc;
}

const std::vector<CKind>& AllKinds() {
  const CPointDesc point({1.0f, 2.0f}, 0.75f);
  const CLineSegDesc seg({0.0f, 1.0f}, {2.0f, 3.0f}, 0.75f);
  const CCircleDesc circle({1.0f, 2.0f}, 0.5f, 0.75f);
  const CArcDesc arc({1.0f, 2.0f}, 0.5f, 0.25f, 2.0f, 0.75f);
  const CDynamicCircleDesc ball({1.0f, 2.0f}, 0.5f, {0.0f, 0.0f}, 1.0f, 0.75f);
  using enum eShape;
  constexpr eMotion moves = eMotion::Kinematic, rests = eMotion::Static;
  static const std::vector<CKind> kinds{
      {"kinematic_point", Turned(point, moves), Point, typeid(CKinematicPoint)},
      {"kinematic_segment", Turned(seg, moves), LineSeg, typeid(CKinematicLineSeg)},
      {"kinematic_circle", Turned(circle, moves), Circle, typeid(CKinematicCircle)},
      {"kinematic_arc", Turned(arc, moves), Arc, typeid(CKinematicArc)},
      {"point", Turned(point, rests), Point, typeid(CPoint)},
      {"segment", Turned(seg, rests), LineSeg, typeid(CLineSeg)},
      {"circle", Turned(circle, rests), Circle, typeid(CCircle)},
      {"arc", Turned(arc, rests), Arc, typeid(CArc)},
      {"ball", ball, Circle, typeid(CDynamicCircle)}};
  return kinds;
}

std::string NameOf(const testing::TestParamInfo<std::size_t>& test) { return AllKinds()[test.param].m_sName; }

class Shape : public testing::TestWithParam<std::size_t> {
protected:
  bool IsKinematic() const { return m_pShape->GetMotionType() == eMotion::Kinematic; }
  const CKind& m_cKind = AllKinds()[GetParam()];
  std::unique_ptr<CShape> m_pShape = MakeShape(m_cKind.m_cDesc);
};
INSTANTIATE_TEST_SUITE_P(, Shape, testing::Range<std::size_t>(0, 9), NameOf);
class KinematicShape : public Shape {};
INSTANTIATE_TEST_SUITE_P(, KinematicShape, testing::Range<std::size_t>(0, 4), NameOf);

TEST_P(Shape, HasTheClassOfItsTypeAndMotionAndWhatItsDescriptorSays) {
  const CShape& shape = *m_pShape;
  const CShapeDesc& desc =
      std::visit([](const CShapeDesc& d) -> const CShapeDesc& { return d; }, m_cKind.m_cDesc);
  EXPECT_EQ(typeid(shape), m_cKind.m_cClass);
  EXPECT_EQ(shape.GetShapeType(), m_cKind.m_eType);
  EXPECT_EQ(desc.m_eShapeType, m_cKind.m_eType);
  EXPECT_EQ(shape.GetMotionType(), desc.m_eMotionType);
  EXPECT_EQ(m_pShape->GetPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(m_pShape->GetElasticity(), 0.75f);
  EXPECT_EQ(CPointDesc().m_fElasticity, 1.0f);
  EXPECT_EQ(CPointDesc().m_vPos, Vector2::Zero());
  EXPECT_FALSE(m_pShape->GetSensor());
  EXPECT_TRUE(m_pShape->GetCanCollide());
  EXPECT_EQ(m_pShape->GetUserPtr(), nullptr);
  EXPECT_EQ(m_pShape->GetOrientation(), 0.0f);
  EXPECT_EQ(m_pShape->GetLastTurn(), 0.0f);
  EXPECT_EQ(m_pShape->GetRotating(), IsKinematic());
}

TEST_P(Shape, SettersAreReadBack) {
  int user = 0;
  m_pShape->SetElasticity(0.5f);
  m_pShape->SetSensor(true);
  m_pShape->SetCanCollide(false);
  m_pShape->SetUserPtr(&user);
  const bool isStatic = m_pShape->GetMotionType() == eMotion::Static;
  const float speed = isStatic ? 0.0f : -2.0f;
  m_pShape->SetRotSpeed(speed);
  if (isStatic) {
    EXPECT_THROW(m_pShape->SetRotSpeed(1), std::invalid_argument);
  }
  m_pShape->SetRotCenter({5.0f, 6.0f});
  EXPECT_EQ(m_pShape->GetElasticity(), 0.5f);
  EXPECT_TRUE(m_pShape->GetSensor());
  EXPECT_FALSE(m_pShape->GetCanCollide());
  EXPECT_EQ(m_pShape->GetUserPtr(), &user);
  EXPECT_EQ(m_pShape->GetRotSpeed(), speed);
  EXPECT_EQ(m_pShape->GetRotCenter(), Vector2(5.0f, 6.0f));
  m_pShape->SetCanCollide();
  EXPECT_TRUE(m_pShape->GetCanCollide());
}

TEST_P(Shape, SetPosMovesTheBoxAlong) {
  CAabb2D moved = m_pShape->GetAABB();
  moved.Translate({4.0f, -8.0f});
  m_pShape->SetPos({5.0f, -6.0f});
  EXPECT_EQ(m_pShape->GetPos(), Vector2(5.0f, -6.0f));
  EXPECT_LE((m_pShape->GetAABB().GetTopLeft() - moved.GetTopLeft()).norm(), 16 * g_fUlp);
  EXPECT_LE((m_pShape->GetAABB().GetBottomRt() - moved.GetBottomRt()).norm(), 16 * g_fUlp);
}

TEST_P(KinematicShape, SetPosDoesNotOutliveARotation) {
  m_pShape->Rotate({1.0f, 0.0f}, 1.0f);
  const Vector2 turned = m_pShape->GetPos();
  m_pShape->SetPos({50.0f, 60.0f});
  m_pShape->Rotate({1.0f, 0.0f}, 1.0f); // from the pose at construction
  EXPECT_EQ(m_pShape->GetPos(), turned);
}

TEST_P(Shape, RelocateOutlivesRotationsUntilReset) {
  const auto pStill = m_pShape->Clone();
  const Vector2 d(49.0f, 58.0f);
  pStill->SetRotCenter({1.0f, 0.0f});
  m_pShape->SetRotCenter({1.0f, 0.0f});
  for (CShape* pShape : {m_pShape.get(), pStill.get()})
    pShape->SetOrientation(1.0f);
  m_pShape->Relocate(m_pShape->GetPos() + d);
  if (IsKinematic()) {
    EXPECT_LE((m_pShape->GetRotCenter() - Vector2(1.0f, 0.0f) - d).norm(), 64 * 3 * g_fUlp);
  }
  const auto expectMoved = [&, &shape = *m_pShape] {
    CAabb2D moved = pStill->GetAABB();
    moved.Translate(d);
    EXPECT_LE((shape.GetPos() - pStill->GetPos() - d).norm(), 64 * 16 * g_fUlp);
    EXPECT_LE((shape.GetAABB().GetTopLeft() - moved.GetTopLeft()).norm(), 64 * 16 * g_fUlp);
    EXPECT_LE((shape.GetAABB().GetBottomRt() - moved.GetBottomRt()).norm(), 64 * 16 * g_fUlp);
  };
  expectMoved();
  for (CShape* pShape : {m_pShape.get(), pStill.get()})
    pShape->SetOrientation(2.0f);
  expectMoved();
  if (!IsKinematic()) return;
  m_pShape->Reset();
  EXPECT_EQ(m_pShape->GetPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(m_pShape->GetRotCenter(), Vector2(1.0f, 0.0f));
}

// A shape that is kept far from the table between games.
TEST_P(Shape, RelocateFarAndBackGivesTheSameShape) {
  m_pShape->SetRotCenter({1.3f, 0.1f});
  m_pShape->SetOrientation(0.7f);
  const Vector2 home(1.1f, 2.7f);
  m_pShape->Relocate(home);
  const auto pStayed = m_pShape->Clone();
  for (const Vector2& far : {Vector2(1e5f, -3e5f), Vector2(-7e8f, 1e3f)}) {
    m_pShape->Relocate(far);
    EXPECT_EQ(m_pShape->GetPos(), far);
    m_pShape->SetOrientation(0.7f); // as its next step does, which rounds it there
    m_pShape->Relocate(home);
    EXPECT_EQ(m_pShape->GetPos(), home);
    EXPECT_EQ(m_pShape->GetRotCenter(), pStayed->GetRotCenter());
    EXPECT_EQ(m_pShape->GetAABB().GetTopLeft(), pStayed->GetAABB().GetTopLeft());
    EXPECT_EQ(m_pShape->GetAABB().GetBottomRt(), pStayed->GetAABB().GetBottomRt());
  }
}

TEST(StaticShape, IsRelocatedWithoutItsUnusedCentre) {
  CPoint point(CPointDesc({-6e17f, 0.0f}));
  point.Relocate({6e17f, 0.0f});
  EXPECT_EQ(point.GetPos(), Vector2(6e17f, 0.0f));
}

TEST_P(Shape, OnlyKinematicShapesTurn) {
  m_pShape->Rotate({1.0f, 0.0f}, g_fPi);
  const Vector2 expected = IsKinematic() ? Vector2(1.0f, -2.0f) : Vector2(1.0f, 2.0f);
  EXPECT_LE((m_pShape->GetPos() - expected).norm(), 16 * g_fUlp);
  EXPECT_EQ(m_pShape->GetOrientation(), IsKinematic() ? g_fPi : 0.0f);
}

TEST_P(KinematicShape, OrientationIsReducedAndSetAboutTheRotationCentre) {
  m_pShape->SetOrientation(-g_fPi / 2);
  EXPECT_NEAR(m_pShape->GetOrientation(), 1.5 * static_cast<double>(g_fPi), 4 * g_fUlp);
  EXPECT_LE((m_pShape->GetPos() - Vector2(3.0f, 0.0f)).norm(), 16 * g_fUlp);
  EXPECT_EQ(m_pShape->GetLastTurn(), 0.0f);
}

TEST_P(Shape, AdvanceTurnsBySpeedTimesTime) {
  m_pShape->Advance(0.5f); // half a revolution a second: a quarter turn
  EXPECT_NEAR(m_pShape->GetOrientation(), IsKinematic() ? g_fPi / 2 : 0.0f, 2 * g_fUlp);
  EXPECT_NEAR(m_pShape->GetLastTurn(), IsKinematic() ? g_fPi / 2 : 0.0f, 2 * g_fUlp);
  EXPECT_LE((m_pShape->GetPos() - (IsKinematic() ? Vector2(-1.0f, 0.0f) : Vector2(1.0f, 2.0f))).norm(),
            16 * g_fUlp);
  m_pShape->Advance(1.0f);
  EXPECT_NEAR(m_pShape->GetOrientation(), IsKinematic() ? 1.5f * g_fPi : 0.0f, 8 * g_fUlp);
  m_pShape->SetRotSpeed(0.0f);
  m_pShape->Advance(1.0f);
  EXPECT_EQ(m_pShape->GetLastTurn(), 0.0f);
  EXPECT_FALSE(m_pShape->GetRotating());
}

// In floats, slow turns would be lost in each step and others wrong: a clock's hand by several percent.
TEST_P(KinematicShape, ManySmallTurnsAreAsRightAsOne) {
  for (const float speed : {1e-5f, -1e-4f, 1.0f / 3600.0f, 0.01f, -0.1f}) {
    SCOPED_TRACE(speed);
    m_pShape->SetOrientation(4.5f);
    m_pShape->SetRotSpeed(speed);
    const float dt = 1.0f / 6000.0f;
    for (int i = 0; i < 100000; ++i)
      m_pShape->Advance(dt);
    const double turned = 2.0 * std::numbers::pi * static_cast<double>(speed) * static_cast<double>(dt) * 1e5;
    const double error = static_cast<double>(m_pShape->GetOrientation()) - 4.5 - turned;
    EXPECT_NEAR(std::remainder(error, 2.0 * std::numbers::pi), 0.0, 0x1p-21); // an ulp of 2 pi
  }
}

TEST_P(KinematicShape, MoveIsAdvanceByTheTimeStep) {
  const std::unique_ptr<CShape> other = m_pShape->Clone();
  m_pShape->move();
  other->Advance(1.0f / 60.0f);
  EXPECT_EQ(m_pShape->GetPos(), other->GetPos());
  EXPECT_EQ(m_pShape->GetOrientation(), other->GetOrientation());
  EXPECT_NEAR(m_pShape->GetLastTurn(), g_fPi / 60, 2 * g_fUlp);
}

TEST_P(Shape, SurfaceVelocityIsThatOfARigidRotation) {
  // pi radians per second about (1, 0).
  const Vector2 v = m_pShape->GetSurfaceVelocity({3.0f, 1.0f});
  EXPECT_LE((v - (IsKinematic() ? Vector2(-g_fPi, 2 * g_fPi) : Vector2(0.0f, 0.0f))).norm(), 16 * g_fUlp);
  EXPECT_EQ(m_pShape->GetSurfaceVelocity({1.0f, 0.0f}), Vector2::Zero());
}

// Bit for bit, after any rotations and a move.
TEST_P(KinematicShape, ResetRestoresThePoseAtConstruction) {
  Tests::CRandom random(41);
  const auto pFresh = m_pShape->Clone();
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < 20; ++k) {
      const Vector2 centre = random.InSquare(50.0f);
      m_pShape->Rotate(centre, random.Uniform(-20.0f, 20.0f));
    }
    m_pShape->Advance(0.3f);
    m_pShape->SetPos(random.InSquare(10.0f));
    m_pShape->Relocate(m_pShape->GetPos() +
                       random.InSquare(1e6f)); // which takes the centre of rotation along
    m_pShape->Reset();
    EXPECT_EQ(m_pShape->GetRotCenter(), pFresh->GetRotCenter());
    EXPECT_EQ(m_pShape->GetPos(), pFresh->GetPos());
    EXPECT_EQ(m_pShape->GetOrientation(), 0.0f);
    EXPECT_EQ(m_pShape->GetLastTurn(), 0.0f);
    EXPECT_EQ(m_pShape->GetAABB().GetTopLeft(), pFresh->GetAABB().GetTopLeft());
    EXPECT_EQ(m_pShape->GetAABB().GetBottomRt(), pFresh->GetAABB().GetBottomRt());
    if (const auto* pSeg = dynamic_cast<const CLineSeg*>(m_pShape.get())) {
      const auto& fresh = static_cast<const CLineSeg&>(*pFresh);
      EXPECT_TRUE(pSeg->GetEndPt0() == fresh.GetEndPt0() && pSeg->GetEndPt1() == fresh.GetEndPt1());
      EXPECT_EQ(pSeg->GetNormal(), fresh.GetNormal());
    }
    if (const auto* pArc = dynamic_cast<const CArc*>(m_pShape.get())) {
      const auto& fresh = static_cast<const CArc&>(*pFresh);
      EXPECT_TRUE(pArc->GetEndPt0() == fresh.GetEndPt0() && pArc->GetEndPt1() == fresh.GetEndPt1());
      EXPECT_EQ(pArc->GetAngle0(), fresh.GetAngle0());
    }
  }
}

TEST_P(Shape, ACloneIsAlikeAndOnItsOwn) {
  int user = 0;
  m_pShape->SetUserPtr(&user);
  m_pShape->SetCanCollide(false);
  m_pShape->SetSensor(true);
  m_pShape->SetElasticity(0.75f);
  m_pShape->Rotate({1.0f, 0.0f}, 0.5f);
  const std::unique_ptr<CShape> clone = m_pShape->Clone();
  const CShape &a = *clone, &b = *m_pShape;
  EXPECT_EQ(typeid(a), typeid(b));
  EXPECT_EQ(clone->GetShapeType(), m_pShape->GetShapeType());
  EXPECT_EQ(clone->GetMotionType(), m_pShape->GetMotionType());
  EXPECT_EQ(clone->GetPos(), m_pShape->GetPos());
  EXPECT_EQ(clone->GetUserPtr(), &user);
  EXPECT_FALSE(clone->GetCanCollide());
  EXPECT_TRUE(clone->GetSensor());
  EXPECT_EQ(clone->GetElasticity(), 0.75f);
  EXPECT_EQ(clone->GetOrientation(), m_pShape->GetOrientation());
  EXPECT_EQ(clone->GetAABB().GetTopLeft(), m_pShape->GetAABB().GetTopLeft());
  const Vector2 pos = m_pShape->GetPos();
  clone->SetPos({70.0f, 80.0f});
  EXPECT_EQ(m_pShape->GetPos(), pos);
  clone->Reset(); // the pose at construction came along
  if (IsKinematic()) {
    EXPECT_EQ(clone->GetPos(), Vector2(1.0f, 2.0f));
  }
}

TEST_P(Shape, APoseThatIsSetIsExact) {
  const Vector2 before = m_pShape->GetPos(), center(0.1f, -0.3f);
  m_pShape->SetPose(center, 0.7f);
  if (!IsKinematic()) {
    EXPECT_EQ(m_pShape->GetPos(), before);
    return;
  }
  EXPECT_EQ(m_pShape->GetRotCenter(), center);
  EXPECT_EQ(m_pShape->GetOrientation(), 0.7f);
  m_pShape->Reset();
  EXPECT_EQ(m_pShape->GetPos(), Vector2(1.0f, 2.0f));
  EXPECT_NE(m_pShape->GetRotCenter(), center);
}

} // namespace
} // namespace Shapes
