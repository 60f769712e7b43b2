// SPDX-License-Identifier: MIT
// What every shape has, tried on each kind.
#include "../Numbers.h"
#include "../Random.h"

#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <vector>

namespace Shapes {
namespace {

struct SKind {
  std::string m_sName;
  std::unique_ptr<CShape> m_pShape;
};

std::vector<SKind> AllKinds() {
  CPointDesc point({1.0f, 2.0f});
  CLineSegDesc seg({0.0f, 1.0f}, {2.0f, 3.0f});
  CCircleDesc circle({1.0f, 2.0f}, 0.5f);
  CArcDesc arc({1.0f, 2.0f}, 0.5f, 0.25f, 2.0f);
  for (CShapeDesc* pDesc : {static_cast<CShapeDesc*>(&point), static_cast<CShapeDesc*>(&seg),
                            static_cast<CShapeDesc*>(&circle), static_cast<CShapeDesc*>(&arc)}) {
    pDesc->m_fRotSpeed = 0.5f;
    pDesc->m_vRotCenter = {1.0f, 0.0f};
  }
  std::vector<SKind> kinds;
  kinds.push_back({"point", std::make_unique<CPoint>(point)});
  kinds.push_back({"segment", std::make_unique<CLineSeg>(seg)});
  kinds.push_back({"circle", std::make_unique<CCircle>(circle)});
  kinds.push_back({"arc", std::make_unique<CArc>(arc)});
  kinds.push_back({"kinematic point", std::make_unique<CKinematicPoint>(point)});
  kinds.push_back({"kinematic segment", std::make_unique<CKinematicLineSeg>(seg)});
  kinds.push_back({"kinematic circle", std::make_unique<CKinematicCircle>(circle)});
  kinds.push_back({"kinematic arc", std::make_unique<CKinematicArc>(arc)});
  kinds.push_back({"ball", std::make_unique<CDynamicCircle>(CDynamicCircleDesc({1.0f, 2.0f}, 0.5f))});
  return kinds;
}

bool IsKinematic(const CShape& shape) { return shape.GetMotionType() == eMotion::Kinematic; }

TEST(Point, IsWhatItsDescriptorSays) {
  const CPointDesc empty;
  EXPECT_EQ(empty.m_eShapeType, eShape::Point);
  EXPECT_EQ(empty.m_vPos, Vector2::Zero());
  EXPECT_EQ(empty.m_fElasticity, 1.0f);

  const CPoint point(CPointDesc({2.0f, 3.0f}, 0.5f));
  EXPECT_EQ(point.GetShapeType(), eShape::Point);
  EXPECT_EQ(point.GetMotionType(), eMotion::Static);
  EXPECT_EQ(point.GetPos(), Vector2(2.0f, 3.0f));
  EXPECT_EQ(point.GetElasticity(), 0.5f);
}

TEST(Shape, HasTheDefaultsOfTheDescriptor) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(p->GetPos(), Vector2(1.0f, 2.0f));
    EXPECT_EQ(p->GetElasticity(), 1.0f);
    EXPECT_FALSE(p->GetSensor());
    EXPECT_TRUE(p->GetCanCollide());
    EXPECT_EQ(p->GetUserPtr(), nullptr);
    EXPECT_EQ(p->GetOrientation(), 0.0f);
    EXPECT_EQ(p->GetLastTurn(), 0.0f);
    EXPECT_EQ(p->GetRotating(), IsKinematic(*p));
  }
}

TEST(Shape, SettersAreReadBack) {
  int user = 0;
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    p->SetElasticity(0.5f);
    p->SetSensor(true);
    p->SetCanCollide(false);
    p->SetUserPtr(&user);
    const bool isStatic = p->GetMotionType() == eMotion::Static;
    const float speed = isStatic ? 0.0f : -2.0f;
    p->SetRotSpeed(speed);
    if (isStatic) {
      EXPECT_THROW(p->SetRotSpeed(1), std::invalid_argument);
    }
    p->SetRotCenter({5.0f, 6.0f});
    EXPECT_EQ(p->GetElasticity(), 0.5f);
    EXPECT_TRUE(p->GetSensor());
    EXPECT_FALSE(p->GetCanCollide());
    EXPECT_EQ(p->GetUserPtr(), &user);
    EXPECT_EQ(p->GetRotSpeed(), speed);
    EXPECT_EQ(p->GetRotCenter(), Vector2(5.0f, 6.0f));
    p->SetCanCollide();
    EXPECT_TRUE(p->GetCanCollide());
  }
}

TEST(Shape, SetPosMovesTheBoxAlong) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    CAabb2D moved = p->GetAABB();
    moved.Translate({4.0f, -8.0f});
    p->SetPos({5.0f, -6.0f});
    EXPECT_EQ(p->GetPos(), Vector2(5.0f, -6.0f));
    EXPECT_LE((p->GetAABB().GetTopLeft() - moved.GetTopLeft()).norm(), 16 * g_fUlp);
    EXPECT_LE((p->GetAABB().GetBottomRt() - moved.GetBottomRt()).norm(), 16 * g_fUlp);
  }
}

TEST(Shape, SetPosDoesNotOutliveARotation) {
  for (const auto& [name, p] : AllKinds()) {
    if (!IsKinematic(*p)) continue;
    SCOPED_TRACE(name);
    p->Rotate({1.0f, 0.0f}, 1.0f);
    const Vector2 turned = p->GetPos();
    p->SetPos({50.0f, 60.0f});
    p->Rotate({1.0f, 0.0f}, 1.0f); // from the pose at construction
    EXPECT_EQ(p->GetPos(), turned);
  }
}

TEST(Shape, RelocateOutlivesRotationsUntilReset) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    const auto pStill = p->Clone();
    const Vector2 d(49.0f, 58.0f);
    pStill->SetRotCenter({1.0f, 0.0f});
    p->SetRotCenter({1.0f, 0.0f});
    for (CShape* pShape : {p.get(), pStill.get()})
      pShape->SetOrientation(1.0f);
    p->Relocate(p->GetPos() + d);
    if (IsKinematic(*p)) {
      EXPECT_EQ(p->GetRotCenter(), Vector2(1.0f, 0.0f) + d);
    }
    const auto expectMoved = [&, &shape = *p] {
      CAabb2D moved = pStill->GetAABB();
      moved.Translate(d);
      EXPECT_LE((shape.GetPos() - pStill->GetPos() - d).norm(), 64 * 16 * g_fUlp);
      EXPECT_LE((shape.GetAABB().GetTopLeft() - moved.GetTopLeft()).norm(), 64 * 16 * g_fUlp);
      EXPECT_LE((shape.GetAABB().GetBottomRt() - moved.GetBottomRt()).norm(), 64 * 16 * g_fUlp);
    };
    expectMoved();
    for (CShape* pShape : {p.get(), pStill.get()})
      pShape->SetOrientation(2.0f);
    expectMoved();
    if (!IsKinematic(*p)) continue;
    p->Reset();
    EXPECT_EQ(p->GetPos(), Vector2(1.0f, 2.0f));
    EXPECT_EQ(p->GetRotCenter(), Vector2(1.0f, 0.0f));
  }
}

TEST(Shape, ResetRestoresTheRotationCentreBitForBit) {
  CLineSegDesc desc({0.3f, 0.1f}, {1.7f, 0.9f});
  desc.m_vRotCenter = {0.1f, 0.7f};
  CKinematicLineSeg seg(desc);
  const Vector2 pos = seg.GetPos();
  for (int i = 0; i < 9; ++i)
    seg.Relocate(seg.GetPos() + Vector2(1e6f, -3e5f));
  seg.Reset();
  EXPECT_EQ(seg.GetRotCenter(), desc.m_vRotCenter);
  EXPECT_EQ(seg.GetPos(), pos);
}

TEST(Shape, AStaticShapeIsRelocatedWithoutItsUnusedCentre) {
  CPoint point(CPointDesc({-6e17f, 0.0f}));
  point.Relocate({6e17f, 0.0f});
  EXPECT_EQ(point.GetPos(), Vector2(6e17f, 0.0f));
}

TEST(Shape, OnlyKinematicShapesTurn) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    p->Rotate({1.0f, 0.0f}, g_fPi);
    const Vector2 expected = IsKinematic(*p) ? Vector2(1.0f, -2.0f) : Vector2(1.0f, 2.0f);
    EXPECT_LE((p->GetPos() - expected).norm(), 16 * g_fUlp);
    EXPECT_EQ(p->GetOrientation(), IsKinematic(*p) ? g_fPi : 0.0f);
  }
}

TEST(Shape, OrientationIsReducedAndSetAboutTheRotationCentre) {
  for (const auto& [name, p] : AllKinds()) {
    if (!IsKinematic(*p)) continue;
    SCOPED_TRACE(name);
    p->SetOrientation(-g_fPi / 2);
    EXPECT_NEAR(p->GetOrientation(), 1.5 * static_cast<double>(g_fPi), 4 * g_fUlp);
    EXPECT_LE((p->GetPos() - Vector2(3.0f, 0.0f)).norm(), 16 * g_fUlp);
    EXPECT_EQ(p->GetLastTurn(), 0.0f);
  }
}

TEST(Shape, AdvanceTurnsBySpeedTimesTime) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    p->Advance(0.5f); // half a revolution a second: a quarter turn
    EXPECT_NEAR(p->GetOrientation(), IsKinematic(*p) ? g_fPi / 2 : 0.0f, 2 * g_fUlp);
    EXPECT_NEAR(p->GetLastTurn(), IsKinematic(*p) ? g_fPi / 2 : 0.0f, 2 * g_fUlp);
    EXPECT_LE((p->GetPos() - (IsKinematic(*p) ? Vector2(-1.0f, 0.0f) : Vector2(1.0f, 2.0f))).norm(),
              16 * g_fUlp);
    p->Advance(1.0f);
    EXPECT_NEAR(p->GetOrientation(), IsKinematic(*p) ? 1.5f * g_fPi : 0.0f, 8 * g_fUlp);
    p->SetRotSpeed(0.0f);
    p->Advance(1.0f);
    EXPECT_EQ(p->GetLastTurn(), 0.0f);
    EXPECT_FALSE(p->GetRotating());
  }
}

TEST(Shape, MoveIsAdvanceByTheTimeStep) {
  for (const auto& [name, p] : AllKinds()) {
    if (!IsKinematic(*p)) continue;
    SCOPED_TRACE(name);
    const std::unique_ptr<CShape> other = p->Clone();
    p->move();
    other->Advance(1.0f / 60.0f);
    EXPECT_EQ(p->GetPos(), other->GetPos());
    EXPECT_EQ(p->GetOrientation(), other->GetOrientation());
    EXPECT_NEAR(p->GetLastTurn(), g_fPi / 60, 2 * g_fUlp);
  }
}

TEST(Shape, SurfaceVelocityIsThatOfARigidRotation) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    // pi radians per second about (1, 0).
    const Vector2 v = p->GetSurfaceVelocity({3.0f, 1.0f});
    EXPECT_LE((v - (IsKinematic(*p) ? Vector2(-g_fPi, 2 * g_fPi) : Vector2(0.0f, 0.0f))).norm(), 16 * g_fUlp);
    EXPECT_EQ(p->GetSurfaceVelocity({1.0f, 0.0f}), Vector2::Zero());
  }
}

// Bit for bit, after any rotations and a move.
TEST(Shape, ResetRestoresThePoseAtConstruction) {
  Tests::CRandom random(41);
  for (const auto& [name, p] : AllKinds()) {
    if (!IsKinematic(*p)) continue;
    SCOPED_TRACE(name);
    const auto pFresh = p->Clone();
    for (int i = 0; i < 200; ++i) {
      for (int k = 0; k < 20; ++k) {
        const Vector2 centre = random.InSquare(50.0f);
        p->Rotate(centre, random.Uniform(-20.0f, 20.0f));
      }
      p->Advance(0.3f);
      p->SetPos(random.InSquare(10.0f));
      p->Reset();
      EXPECT_EQ(p->GetPos(), pFresh->GetPos());
      EXPECT_EQ(p->GetOrientation(), 0.0f);
      EXPECT_EQ(p->GetLastTurn(), 0.0f);
      EXPECT_EQ(p->GetAABB().GetTopLeft(), pFresh->GetAABB().GetTopLeft());
      EXPECT_EQ(p->GetAABB().GetBottomRt(), pFresh->GetAABB().GetBottomRt());
      if (const auto* pSeg = dynamic_cast<const CLineSeg*>(p.get())) {
        const auto& fresh = static_cast<const CLineSeg&>(*pFresh);
        EXPECT_TRUE(pSeg->GetEndPt0() == fresh.GetEndPt0() && pSeg->GetEndPt1() == fresh.GetEndPt1());
        EXPECT_EQ(pSeg->GetNormal(), fresh.GetNormal());
      }
      if (const auto* pArc = dynamic_cast<const CArc*>(p.get())) {
        const auto& fresh = static_cast<const CArc&>(*pFresh);
        EXPECT_TRUE(pArc->GetEndPt0() == fresh.GetEndPt0() && pArc->GetEndPt1() == fresh.GetEndPt1());
        EXPECT_EQ(pArc->GetAngle0(), fresh.GetAngle0());
      }
    }
  }
}

TEST(Shape, ACloneIsAlikeAndOnItsOwn) {
  int user = 0;
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    p->SetUserPtr(&user);
    p->SetCanCollide(false);
    p->SetSensor(true);
    p->SetElasticity(0.75f);
    p->Rotate({1.0f, 0.0f}, 0.5f);
    const std::unique_ptr<CShape> clone = p->Clone();
    const CShape &a = *clone, &b = *p;
    EXPECT_EQ(typeid(a), typeid(b));
    EXPECT_EQ(clone->GetShapeType(), p->GetShapeType());
    EXPECT_EQ(clone->GetMotionType(), p->GetMotionType());
    EXPECT_EQ(clone->GetPos(), p->GetPos());
    EXPECT_EQ(clone->GetUserPtr(), &user);
    EXPECT_FALSE(clone->GetCanCollide());
    EXPECT_TRUE(clone->GetSensor());
    EXPECT_EQ(clone->GetElasticity(), 0.75f);
    EXPECT_EQ(clone->GetOrientation(), p->GetOrientation());
    EXPECT_EQ(clone->GetAABB().GetTopLeft(), p->GetAABB().GetTopLeft());
    const Vector2 pos = p->GetPos();
    clone->SetPos({70.0f, 80.0f});
    EXPECT_EQ(p->GetPos(), pos);
    clone->Reset(); // the pose at construction came along
    if (IsKinematic(*p)) {
      EXPECT_EQ(clone->GetPos(), Vector2(1.0f, 2.0f));
    }
  }
}

TEST(Shape, APoseThatIsSetIsExact) {
  for (const auto& [name, p] : AllKinds()) {
    SCOPED_TRACE(name);
    const Vector2 before = p->GetPos(), center(0.1f, -0.3f);
    p->SetPose(center, 0.7f);
    if (!IsKinematic(*p)) {
      EXPECT_EQ(p->GetPos(), before);
      continue;
    }
    EXPECT_EQ(p->GetRotCenter(), center);
    EXPECT_EQ(p->GetOrientation(), 0.7f);
    p->Reset();
    EXPECT_EQ(p->GetPos(), Vector2(1.0f, 2.0f));
    EXPECT_NE(p->GetRotCenter(), center);
  }
}

const std::type_info& ClassOf(const CShape& shape) { return typeid(shape); }

TEST(MakeShapeTest, TheClassIsThatOfTypeAndMotion) {
  const CPointDesc point({1.0f, 2.0f});
  const CLineSegDesc seg({0.0f, 1.0f}, {2.0f, 3.0f});
  const CCircleDesc circle({1.0f, 2.0f}, 0.5f);
  const CArcDesc arc({1.0f, 2.0f}, 0.5f, 0.25f, 2.0f);
  const auto expect = [](CAnyShapeDesc any, const std::type_info& still, const std::type_info& kinematic) {
    const auto pStill = MakeShape(any);
    EXPECT_EQ(ClassOf(*pStill), still);
    std::visit([](CShapeDesc& desc) { desc.m_eMotionType = eMotion::Kinematic; }, any);
    const auto pKinematic = MakeShape(any);
    EXPECT_EQ(ClassOf(*pKinematic), kinematic);
    EXPECT_EQ(pStill->GetAABB().GetTopLeft(), pKinematic->GetAABB().GetTopLeft());
    std::visit([](CShapeDesc& desc) { desc.m_eMotionType = eMotion::Dynamic; }, any);
    EXPECT_THROW(MakeShape(any), std::invalid_argument);
  };
  expect(point, typeid(CPoint), typeid(CKinematicPoint));
  expect(seg, typeid(CLineSeg), typeid(CKinematicLineSeg));
  expect(circle, typeid(CCircle), typeid(CKinematicCircle));
  expect(arc, typeid(CArc), typeid(CKinematicArc));
  const auto pBall = MakeShape(CDynamicCircleDesc({1.0f, 2.0f}, 0.5f));
  EXPECT_EQ(ClassOf(*pBall), typeid(CDynamicCircle));
}

} // namespace
} // namespace Shapes
