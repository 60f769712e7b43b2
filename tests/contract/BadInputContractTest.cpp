// SPDX-License-Identifier: MIT
// Values that no shape, ball or world can have are refused before anything is changed, with the field and the
// value in the message.
#include "../fuzz/Fuzz.h"
#include "Backends.h"

namespace Shapes {
namespace {

class CBadInputContract : public CEveryBackend {
protected:
  /// A world with a bounce between a segment and a point, another ball in the way, and a flipper.
  std::unique_ptr<CWorld> MakeBusy() {
    auto pWorld = Backend().MakeWorld(Described({0, -9.8f}));
    pWorld->Add(CLineSegDesc({-2, 0}, {2, 0}));
    pWorld->Add(CPointDesc({0, 0}));
    m_cBall = pWorld->Add(CDynamicCircleDesc({0.1f, 0.4f}, 0.1f, {0, -1}));
    pWorld->Add(CDynamicCircleDesc({0.15f, 0.7f}, 0.1f));
    m_cFlipper = pWorld->Add(Kinematic());
    return pWorld;
  }

  static CLineSegDesc Kinematic() { return Turning(CLineSegDesc({4, 0}, {5, 0}), 0); }

  /// Calls f, which must throw std::invalid_argument whose message has both words in it, and must not have
  /// changed the world: it goes on with the bits of one to which nothing was said.
  void ExpectRefused(const std::function<void()>& f, const std::string& field, const std::string& value) {
    const CShapeId next{m_cFlipper.m_nValue + 1};
    const std::string message = MessageOf<std::invalid_argument>(f);
    for (const std::string& part : {field, value, std::string("expected")})
      EXPECT_TRUE(Says(message, part));
    EXPECT_FALSE(m_pWorld->Contains(next));
    for (CWorld* pWorld : {m_pWorld.get(), m_pUntouched.get()})
      Steps(*pWorld, 5);
    EXPECT_TRUE(HaveSameBits(*m_pWorld, *m_pUntouched));
  }

  CShapeId m_cBall, m_cFlipper;
  std::unique_ptr<CWorld> m_pWorld = MakeBusy(), m_pUntouched = MakeBusy();
};
SHAPES_ON_EVERY_BACKEND(CBadInputContract);

// Of each kind of refusal one: all of them are in tests/shapes/ValidateTest.cpp.
TEST_P(CBadInputContract, ShapesAndBallsAreChecked) {
  const auto refuse = [&](const CAnyShapeDesc& desc, const char* field, const char* value) {
    ExpectRefused([&] { m_pWorld->Add(desc); }, field, value);
  };
  refuse(CPointDesc(Vector2(g_fNan, 0)), "m_vPos", "nan");
  refuse(Turning(CLineSegDesc({0, 0}, {1, 0}), 0, {g_fInf, 0}), "m_vRotCenter", "inf");
  const Vector2 above(0, 3), rest(0, 0);
  refuse(CDynamicCircleDesc({g_fNan, 0}, 1), "m_vPos", "nan");
  refuse(CDynamicCircleDesc(above, 1, {g_fInf, 0}), "m_vVel", "inf");
  refuse(CDynamicCircleDesc(above, -1), "m_fRadius", "-1");
  refuse(CDynamicCircleDesc(above, 0.1f, rest, 0), "m_fMass", "0");
  refuse(CDynamicCircleDesc(above, 0.1f, rest, g_fNan), "m_fMass", "nan");
  refuse(CDynamicCircleDesc(above, 0.1f, rest, 1, -1), "m_fElasticity", "-1");
  CDynamicCircleDesc spinning(above, 0.1f), stopped(above, 0.1f);
  spinning.m_fRotSpeed = 2;
  refuse(spinning, "m_fRotSpeed", "2");
  stopped.m_cLimits = CMotionLimits::OfAngle(0, 1);
  refuse(stopped, "m_cLimits", "set");
}

TEST_P(CBadInputContract, CompoundsAreCheckedAlsoWithoutAShape) {
  for (const std::vector<CAnyShapeDesc>& descs :
       {std::vector<CAnyShapeDesc>(), std::vector<CAnyShapeDesc>{CPointDesc(Vector2(0, 0))}}) {
    const auto refuse = [&](const Vector2& center, float revs, const Vector2& v, const char* field) {
      ExpectRefused([&] { m_pWorld->AddCompound(descs, center, revs, v); }, field, "inf");
    };
    refuse({g_fInf, 0}, 0, {0, 0}, "m_vRotCenter");
    refuse({0, 0}, g_fInf, {0, 0}, "m_fRotSpeed");
    refuse({0, 0}, 0, {g_fInf, 0}, "m_vVel");
  }
  EXPECT_TRUE(m_pWorld->AddCompound({}, {0, 0}).empty()); // the control
}

TEST_P(CBadInputContract, SettersAreChecked) {
  ExpectRefused([&] { m_pWorld->SetPos(m_cBall, {g_fNan, 0}); }, "m_vPos", "nan");
  ExpectRefused([&] { m_pWorld->SetVel(m_cBall, {0, g_fInf}); }, "m_vVel", "inf");
  ExpectRefused([&] { m_pWorld->SetElasticity(m_cBall, g_fNan); }, "m_fElasticity", "nan");
  ExpectRefused([&] { m_pWorld->SetElasticity(m_cFlipper, -1); }, "m_fElasticity", "-1");
  ExpectRefused([&] { m_pWorld->SetRotSpeed(m_cFlipper, g_fInf); }, "m_fRotSpeed", "inf");
  ExpectRefused([&] { m_pWorld->SetRotCenter(m_cFlipper, {g_fNan, 0}); }, "m_vRotCenter", "nan");
  ExpectRefused([&] { m_pWorld->SetOrientation(m_cFlipper, g_fNan); }, "angle", "nan");
  ExpectRefused([&] { m_pWorld->SetVel(m_cFlipper, {g_fNan, 0}); }, "m_vVel", "nan");
  ExpectRefused([&] { m_pWorld->SetGravity({0, g_fNan}); }, "m_vGravity", "nan");
  // By shapes that have none.
  const CShapeId fixed = m_pWorld->Add(CPointDesc({9, 9}));
  EXPECT_EQ(m_pWorld->GetVel(fixed), Vector2(0, 0));
  EXPECT_THROW(m_pWorld->SetVel(fixed, {1, 0}), std::invalid_argument);
  EXPECT_THROW(m_pWorld->SetRotSpeed(fixed, 1), std::invalid_argument);
  EXPECT_THROW(m_pWorld->SetRotSpeed(m_cBall, 1), std::invalid_argument);
  const CShapeId some[] = {m_cFlipper, fixed};
  const float speed = m_pWorld->GetRotSpeed(m_cFlipper);
  EXPECT_THROW(m_pWorld->SetRotSpeed(some, speed + 1), std::invalid_argument);
  EXPECT_EQ(m_pWorld->GetRotSpeed(m_cFlipper), speed);
  const Vector2 v = m_pWorld->GetVel(m_cFlipper);
  EXPECT_THROW(m_pWorld->SetVel(some, v + Vector2(1, 0)), std::invalid_argument);
  EXPECT_THROW(m_pWorld->SetVel(std::span(some, 1), {g_fNan, 0}), std::invalid_argument);
  EXPECT_EQ(m_pWorld->GetVel(m_cFlipper), v);
  EXPECT_THROW(m_pWorld->GetShape(m_cBall), std::invalid_argument);
}

TEST_P(CBadInputContract, UnknownIdsAreRefused) {
  const CShapeId unknown{77};
  EXPECT_THROW(m_pWorld->Remove(CShapeId{}), std::invalid_argument);
  ExpectRefused([&] { m_pWorld->Remove(unknown); }, "id", "77");
  ExpectRefused([&] { m_pWorld->SetPos(unknown, {0, 0}); }, "id", "77");
  ExpectRefused([&] { m_pWorld->SetVel(unknown, {0, 0}); }, "id", "77");
  ExpectRefused([&] { m_pWorld->GetShape(unknown); }, "id", "77");
}

// Where a ball would do, the message does not ask for a shape that is none.
TEST_P(CBadInputContract, AMessageSaysWhetherABallWouldDo) {
  const CShapeId gone{77};
  const std::function<void()> ofEither[] = {
      [&] { m_pWorld->Remove(gone); },          [&] { m_pWorld->GetPos(gone); },
      [&] { m_pWorld->SetPos(gone, {0, 0}); },  [&] { m_pWorld->GetVel(gone); },
      [&] { m_pWorld->SetVel(gone, {0, 0}); },  [&] { m_pWorld->GetUserPtr(gone); },
      [&] { m_pWorld->SetSensor(gone, true); }, [&] { m_pWorld->GetShapeType(gone); },
      [&] { m_pWorld->GetMotionType(gone); }};
  for (const auto& f : ofEither)
    EXPECT_EQ(MessageOf<std::invalid_argument>(f),
              "id is 77: expected the id of a shape or a ball in this world");
  const std::function<void()> ofShapes[] = {[&] { m_pWorld->GetShape(m_cBall); },
                                            [&] { m_pWorld->SetRotSpeed(gone, 1); }};
  for (const auto& f : ofShapes)
    EXPECT_TRUE(
        Says(MessageOf<std::invalid_argument>(f), "the id of a shape in this world that is not a ball"));
}

TEST_P(CBadInputContract, WorldDescriptionsAreChecked) {
  const auto refuse = [&](auto change, const char* field, const char* value) {
    CWorldDesc desc;
    change(desc);
    ExpectRefused([&] { Backend().MakeWorld(desc); }, field, value);
  };
  refuse([](auto& d) { d.m_fTimeStep = 0; }, "m_fTimeStep", "0");
  refuse([](auto& d) { d.m_fTimeStep = -1; }, "m_fTimeStep", "-1");
  refuse([](auto& d) { d.m_fTimeStep = g_fNan; }, "m_fTimeStep", "nan");
  refuse([](auto& d) { d.m_fTimeStep = g_fInf; }, "m_fTimeStep", "inf");
  refuse([](auto& d) { d.m_vGravity.y() = g_fNan; }, "m_vGravity", "nan");
  refuse([](auto& d) { d.m_fTimeStep = 1e-39f; }, "m_fTimeStep / m_nSubsteps", "1e-39");
  refuse([](auto& d) { d.m_cBox2D.m_fLengthUnit = -1, d.m_vGravity = {0, -10}; }, "m_fLengthUnit", "-1");
  refuse([](auto& d) { d.m_nSubsteps = 0; }, "m_nSubsteps", "0");
  refuse([](auto& d) { d.m_nSubsteps = g_nMaxSubsteps + 1; }, "m_nSubsteps", "4097");
  refuse([](auto& d) { d.m_nThreads = 0; }, "m_nThreads", "0");
  refuse([](auto& d) { d.m_cBox2D.m_fLengthUnit = 0; }, "m_fLengthUnit", "0");
  refuse([](auto& d) { d.m_cBox2D.m_fSagittaTolerance = -1; }, "m_fSagittaTolerance", "-1");
  refuse([](auto& d) { d.m_cBox2D.m_nVelocityIterations = 0; }, "m_nVelocityIterations", "0");
  refuse([](auto& d) { d.m_cBox2D.m_eProfile = static_cast<eProfile>(9); }, "m_eProfile", "9");
}

TEST_P(CBadInputContract, AStateThatTheEngineCannotHoldIsNotLoaded) {
  auto pFar = GetBackend(eBackend::Native)->MakeWorld(CWorldDesc());
  pFar->Add(CDynamicCircleDesc({1e17f, 0}, 1));
  const CSavedState saved = pFar->SaveState();
  if (!IsBox2D())
    EXPECT_NO_THROW(m_pWorld->LoadState(saved));
  else
    ExpectRefused([&] { m_pWorld->LoadState(saved); }, "corner of the box", "1e+17");
}

// Also of a shape that only waits for its speed, as Kinematics is forbidden.
TEST_P(CBadInputContract, AStateWithASpeedThatTheEngineCannotHoldIsNotLoaded) {
  CWorldDesc still;
  still.m_cEffects = {{}, {eEffect::Kinematics}};
  auto pFast = GetBackend(eBackend::Native)->MakeWorld(still);
  CLineSegDesc paddle({0, 0}, {1, 0});
  paddle.m_eMotionType = eMotion::Kinematic;
  paddle.m_vVel = {1e17f, 0};
  pFast->Add(paddle);
  const CSavedState saved = pFast->SaveState();
  if (!IsBox2D())
    EXPECT_NO_THROW(m_pWorld->LoadState(saved));
  else
    ExpectRefused([&] { m_pWorld->LoadState(saved); }, "m_vVel", "1e+17");
}

TEST_P(CBadInputContract, TheLargestKickIsFiniteAndInTheRightDirection) {
  auto pWorld = Backend().MakeWorld(CWorldDesc());
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}, g_fMaxElasticity));
  const float speed = IsBox2D() ? g_fMaxBox2DSpeed : g_fMaxSpeed,
              mass = IsBox2D() ? g_fMaxBox2DMass : g_fMaxMass;
  const CShapeId ball =
      pWorld->Add(CDynamicCircleDesc({0, 0.05f}, 0.1f, {0, -speed}, mass, g_fMaxElasticity));
  Steps(*pWorld, 3);
  EXPECT_TRUE(pWorld->GetPos(ball).allFinite());
  EXPECT_TRUE(pWorld->GetVel(ball).allFinite());

  // The surface of a shape far from its centre is faster than any ball.
  CGameClock::Set(1.0f / 60.0f, 0.0f);
  CPointDesc desc(Vector2(0, 0), g_fMaxElasticity);
  desc.m_vRotCenter = {1e17f, 0};
  desc.m_fRotSpeed = g_fMaxRotSpeed;
  CKinematicPoint point(desc);
  CDynamicCircle struck(CDynamicCircleDesc({0.3f, -0.4f}, 1, {0, 0}, 1, g_fMaxElasticity));
  CContactDesc c(&point, &struck);
  ASSERT_TRUE(GetBackend(eBackend::Native)->CollisionDetected(c));
  struck.CollisionResponse(c);
  EXPECT_NEAR(struck.GetVel().norm() / g_fMaxSpeed, 1.0, 4 * g_fUlp);
  EXPECT_LT(struck.GetVel().y(), 0.0f); // away from the point
  EXPECT_TRUE(struck.GetSpeedCapped());
}

TEST_P(CBadInputContract, LargestAndSmallestValuesAreStepped) {
  // At the limits of what is accepted nothing aborts and nothing is NaN. Box2D's are narrower; beyond them it
  // would abort the program, so they are refused: OwnedEngineTest.cpp, NoAssertTest.cpp.
  const float most = IsBox2D() ? 0.9f * g_fMaxBox2DLength : g_fMaxLength;
  const float speed = IsBox2D() ? g_fMaxBox2DSpeed : g_fMaxSpeed;
  const float heavy = IsBox2D() ? g_fMaxBox2DMass : g_fMaxMass,
              light = IsBox2D() ? g_fMinBox2DMass : g_fMinMass;
  const auto pWorld = Backend().MakeWorld(CWorldDesc());
  pWorld->Add(CCircleDesc({0, 0}, most));
  pWorld->Add(CLineSegDesc({-most, -most}, {most, most}));
  pWorld->Add(CArcDesc({most / 2, 0}, most / 2, 0, 0));
  pWorld->Add(CPointDesc(Vector2(most, -most)));
  pWorld->Add(CDynamicCircleDesc({most, most}, 1, {-speed, -speed}, heavy));
  pWorld->Add(CDynamicCircleDesc({0, 0}, 0, {0, speed}, light));
  pWorld->Add(CDynamicCircleDesc({0, 0}, 1e-30f, {0, 1e-30f}, 1));
  Steps(*pWorld, 20);
  EXPECT_NO_THROW(Fuzz::RequireSound(*pWorld));
}

} // namespace
} // namespace Shapes
