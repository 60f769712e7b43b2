// SPDX-License-Identifier: MIT
// Every value that no shape can have is refused, with a message that names the field and the value.

#include "shapes/Validate.h"

#include "../Testing.h"

namespace Shapes {
namespace {

constexpr float g_fHuge = std::numeric_limits<float>::max();
const std::string g_sHuge = "3.4028235e+38";

std::string Refusal(const std::function<void()>& f) { return MessageOf<std::invalid_argument>(f); }

void ExpectRefused(const std::string& field, const std::string& value, const std::function<void()>& f) {
  const std::string message = Refusal(f);
  EXPECT_EQ(message.substr(0, message.find(" is ")), field) << "value " << value << ": " << message;
  EXPECT_TRUE(Says(message, value)) << field;
  EXPECT_TRUE(Says(message, "expected")) << field;
}

struct SBad {
  float m_fValue;
  std::string m_sText;
};
const std::vector<SBad> g_stdNotFinite = {{g_fNan, "nan"}, {g_fInf, "inf"}, {-g_fInf, "-inf"}};
std::vector<SBad> NotFiniteAnd(std::vector<SBad> more) {
  more.insert(more.end(), g_stdNotFinite.begin(), g_stdNotFinite.end());
  return more;
}

// Every kind of shape, static and kinematic, and a ball: made from a descriptor after `change`, if that can
// change such a one.
template <class F>
void ExpectAllRefused(const std::string& field, const std::string& value, const F& change,
                      bool segments = true) {
  const auto refuse = [&]<class TDesc>(TDesc desc) {
    if constexpr (std::is_invocable_v<F, TDesc&>) {
      change(desc);
      for (const eMotion motion : {eMotion::Static, eMotion::Kinematic}) {
        if (desc.m_eMotionType != eMotion::Dynamic) desc.m_eMotionType = motion;
        ExpectRefused(field, value, [&] { MakeShape(desc); });
      }
    }
  };
  refuse(CPointDesc({1.0f, 2.0f}));
  refuse(CCircleDesc({1.0f, 2.0f}, 1.0f));
  refuse(CArcDesc({1.0f, 2.0f}, 1.0f, 0.0f, 1.0f));
  refuse(CDynamicCircleDesc({1.0f, 2.0f}, 1.0f));
  if (segments) refuse(CLineSegDesc({0.0f, 1.0f}, {2.0f, 3.0f}));
}

TEST(Validate, Position) {
  for (const auto& [value, text] : NotFiniteAnd({{g_fHuge, g_sHuge}, {-g_fHuge, "-" + g_sHuge}})) {
    // The position of a segment follows its ends.
    ExpectAllRefused(
        "m_vPos", "(" + text + ", 2)", [v = value](CShapeDesc& d) { d.m_vPos.x() = v; }, false);
    ExpectAllRefused(
        "m_vPos", "(1, " + text + ")", [v = value](CShapeDesc& d) { d.m_vPos.y() = v; }, false);
  }
}

TEST(Validate, Elasticity) {
  for (const auto& [value, text] : NotFiniteAnd({{-1.0f, "-1"}, {g_fHuge, g_sHuge}, {2e6f, "2e+06"}}))
    ExpectAllRefused("m_fElasticity", text, [v = value](CShapeDesc& d) { d.m_fElasticity = v; });
}

TEST(Validate, RotationSpeedAndCentre) {
  for (const auto& [value, text] : NotFiniteAnd({{2e9f, "2e+09"}, {-2e9f, "-2e+09"}, {g_fHuge, g_sHuge}}))
    ExpectAllRefused("m_fRotSpeed", text, [v = value](CShapeDesc& d) { d.m_fRotSpeed = v; });
  for (const auto& [value, text] : NotFiniteAnd({{g_fHuge, g_sHuge}}))
    ExpectAllRefused("m_vRotCenter", "(0, " + text + ")",
                     [v = value](CShapeDesc& d) { d.m_vRotCenter.y() = v; });
}

TEST(Validate, Radius) {
  for (const auto& [value, text] : NotFiniteAnd({{-1.0f, "-1"},
                                                 {-std::numeric_limits<float>::denorm_min(), "-1e-45"},
                                                 {g_fHuge, g_sHuge},
                                                 {2e19f, "2e+19"}}))
    ExpectAllRefused("m_fRadius", text, [v = value](CCircleDesc& d) { d.m_fRadius = v; });
}

TEST(Validate, ArcAngles) {
  for (const auto& [value, text] : g_stdNotFinite) {
    ExpectAllRefused("m_fAngle0", text, [v = value](CArcDesc& d) { d.SetAngles(v, 1.0f); });
    ExpectAllRefused("m_fAngle1", text, [v = value](CArcDesc& d) { d.SetAngles(1.0f, v); });
    ExpectAllRefused("m_fAngle0", text, [v = value](CArcDesc& d) { d.SetAngles(v, v); });
  }
}

TEST(Validate, SegmentEnds) {
  // Whichever way round they are given, the message is of the end that is bad, not of what follows from it.
  for (const auto& [value, text] :
       NotFiniteAnd({{g_fHuge, g_sHuge}, {-g_fHuge, "-" + g_sHuge}, {1.5e18f, "1.5"}})) {
    const CLineSegDesc high({1.0f, 2.0f}, {3.0f, value}), wide({value, 2.0f}, {1.0f, 2.0f});
    ExpectRefused("m_vPt1", "(3, " + text, [&] { CLineSeg shape(high); });
    ExpectRefused("m_vPt1", "(3, " + text, [&] { CKinematicLineSeg shape(high); });
    const std::string message = Refusal([&] { CLineSeg shape(wide); });
    EXPECT_EQ(message.substr(0, 5), "m_vPt") << "end (" << text << ", 2): " << message;
    EXPECT_TRUE(Says(message, "(" + text));
  }
}

TEST(Validate, SidesAndMotion) {
  ExpectAllRefused(
      "m_eSides", "77", []<class TDesc>(TDesc & desc) requires requires { desc.m_eSides; } {
        desc.m_eSides = static_cast<eSides>(77);
      });
  const auto refuse = [](auto desc, eMotion motion, const char* value) {
    desc.m_eMotionType = motion;
    ExpectRefused("m_eMotionType", value, [&] { MakeShape(desc); });
  };
  refuse(CPointDesc(), eMotion::Dynamic, "neither");
  refuse(CLineSegDesc(), eMotion::Dynamic, "neither");
  refuse(CCircleDesc(), eMotion::Dynamic, "neither");
  refuse(CArcDesc(), eMotion::Dynamic, "neither");
  refuse(CDynamicCircleDesc(), eMotion::Static, "not Dynamic");
}

TEST(Validate, VelocityAndMass) {
  const auto ball = [](const Vector2& v, float m) {
    CDynamicCircle shape(CDynamicCircleDesc(Vector2(0.0f, 0.0f), 1.0f, v, m));
  };
  for (const auto& [value, text] : NotFiniteAnd({{g_fHuge, g_sHuge}})) {
    ExpectRefused("m_vVel", "(" + text + ", 0)", [&, v = value] { ball({v, 0.0f}, 1.0f); });
    ExpectRefused("m_vVel", "(0, " + text + ")", [&, v = value] { ball({0.0f, v}, 1.0f); });
    ExpectRefused("m_fMass", text, [&, v = value] { ball({0.0f, 0.0f}, v); });
  }
  ExpectRefused("m_fMass", "0", [&] { ball({0.0f, 0.0f}, 0.0f); });
  ExpectRefused("m_fMass", "-0", [&] { ball({0.0f, 0.0f}, -0.0f); });
  ExpectRefused("m_fMass", "-1", [&] { ball({0.0f, 0.0f}, -1.0f); });
  ExpectRefused("m_fMass", "1e-45", [&] { ball({0.0f, 0.0f}, std::numeric_limits<float>::denorm_min()); });
}

TEST(Validate, LimitsThemselvesAreAccepted) {
  CDynamicCircleDesc desc({g_fMaxLength, -g_fMaxLength}, g_fMaxLength, {g_fMaxSpeed, 0.0f}, g_fMaxMass,
                          g_fMaxElasticity);
  desc.m_fRotSpeed = -g_fMaxRotSpeed;
  EXPECT_NO_THROW(CDynamicCircle shape(desc));
  EXPECT_NO_THROW(CCircle(CCircleDesc({0.0f, 0.0f}, 0.0f, 0.0f)));
  EXPECT_NO_THROW(CLineSeg(CLineSegDesc({g_fMaxLength, 0.0f}, {0.0f, 0.0f})));
  EXPECT_NO_THROW(CDynamicCircle(CDynamicCircleDesc({0.0f, 0.0f}, 0.0f, {0.0f, 0.0f}, g_fMinMass)));
}

TEST(Validate, SettersRefuseAndChangeNothing) {
  CDynamicCircle ball(CDynamicCircleDesc({1.0f, 2.0f}, 1.0f, {3.0f, 4.0f}));
  CKinematicLineSeg seg(CLineSegDesc({0.0f, 0.0f}, {1.0f, 0.0f}));
  seg.Rotate({0.0f, 0.0f}, 0.5f);
  const Vector2 end = seg.GetEndPt1();
  for (const auto& [value, text] : g_stdNotFinite) {
    const float v = value;
    ExpectRefused("m_vPos", text, [&] { ball.SetPos({v, 0.0f}); });
    ExpectRefused("m_vVel", text, [&] { ball.SetVel({0.0f, v}); });
    ExpectRefused("m_fElasticity", text, [&] { ball.SetElasticity(v); });
    ExpectRefused("m_fRotSpeed", text, [&] { seg.SetRotSpeed(v); });
    ExpectRefused("m_vRotCenter", text, [&] { seg.SetRotCenter({0.0f, v}); });
    ExpectRefused("center", text, [&] { seg.Rotate({v, 0.0f}, 1.0f); });
    ExpectRefused("angle", text, [&] { seg.Rotate({0.0f, 0.0f}, v); });
    ExpectRefused("angle", text, [&] { seg.SetOrientation(v); });
  }
  ExpectRefused("m_fElasticity", "-1", [&] { ball.SetElasticity(-1.0f); });
  EXPECT_EQ(ball.GetPos(), Vector2(1.0f, 2.0f));
  EXPECT_EQ(ball.GetVel(), Vector2(3.0f, 4.0f));
  EXPECT_EQ(ball.GetElasticity(), 1.0f);
  EXPECT_EQ(seg.GetRotSpeed(), 0.0f);
  EXPECT_EQ(seg.GetRotCenter(), Vector2(0.0f, 0.0f));
  EXPECT_EQ(seg.GetOrientation(), 0.5f);
  EXPECT_EQ(seg.GetEndPt1(), end);
}

TEST(Validate, MessageSaysFieldValueAndWhatIsExpected) {
  EXPECT_EQ(Refusal([] { RequireRange("m_fX", -1.0f, 0.0f, 2.0f); }),
            "m_fX is -1: expected a number from 0 to 2");
  EXPECT_EQ(Refusal([] { RequirePositive("m_fX", 0.0f, 2.0f); }),
            "m_fX is 0: expected a number above 0, up to 2");
  EXPECT_EQ(Refusal([] { RequireFinite("m_fX", g_fNan); }), "m_fX is nan: expected a finite number");
  EXPECT_EQ(Refusal([] { RequireVector("m_vX", Vector2(g_fInf, 1.0f), 2.0f); }),
            "m_vX is (inf, 1): expected finite coordinates of at most 2 in size");
  EXPECT_EQ(Refusal([] { RequireRange("m_fX", 2.0f, 0.0f, 2.0f); }), "");
  EXPECT_EQ(Refusal([] { RequireVector("m_vX", {2.0f, -2.0f}, 2.0f); }), "");
}

} // namespace
} // namespace Shapes
