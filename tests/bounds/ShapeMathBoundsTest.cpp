// SPDX-License-Identifier: MIT
// The bounds of ShapeMath.h.
#include "Inputs.h"
#include "Worst.h"

#include <cmath>

namespace Shapes::Bounds {
namespace {

constexpr int g_nShapeMathBoundsTrials = 10000;

// Every finite float alike, denormals included; a component may be 0.
Vector2 AnyVector(CRandom& random, int leastExp, int mostExp) {
  const float x = random.Below(16) ? random.SignedScale(leastExp, mostExp) : 0.0f;
  const float y = random.Below(2) ? random.SignedScale(leastExp, mostExp) : x * NearOne(random);
  return {x, y};
}

TEST(ShapeMathBounds, Cross) {
  CRandom random(1001);
  CWorst worst("Cross"), single("Cross from a sum of products that were not rounded apart");
  for (int i = 0; i < g_nShapeMathBoundsTrials; ++i) {
    const Vector2 a = AnyVector(random, -80, 60);
    const Vector2 b = i % 2 ? Vector2(NearOne(random) * a) : AnyVector(random, -80, 60);
    const CVec ea = Exact(a), eb = Exact(b);
    const CFifty bound = g_fUlp * (abs(ea.x * eb.y) + abs(ea.y * eb.x)) + CFifty(0x1p-149);
    worst.See(abs(Shapes::Cross(a, b) - Cross(ea, eb)), bound);
    // By the angle between them.
    const float angle = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
    single.See(abs(a.norm() * b.norm() * std::sin(angle) - Cross(ea, eb)), bound);
    ASSERT_EQ(Shapes::Cross(a, a), 0.0f);
  }
  worst.ExpectKept(g_nShapeMathBoundsTrials);
  single.ExpectBroken();
}

TEST(ShapeMathBounds, LengthAndNormalize) {
  CRandom random(1002);
  CWorst length("Length"), unit("Normalize"), one("Length of Normalize");
  CWorst squares("Length by float squares"), quotient("Normalize by float squares");
  for (int i = 0; i < g_nShapeMathBoundsTrials; ++i) {
    const Vector2 v = i % 2 ? AnyVector(random, -149, 126) : AnyWay(random, AnySize(random));
    if (v == Vector2::Zero()) continue;
    const CVec e = Exact(v);
    const CFifty d = Norm(e);
    const CFifty bound = g_fUlp * d + CFifty(0x1p-149);
    length.See(abs(Length(v) - d), bound);
    squares.See(abs(std::sqrt(v.x() * v.x() + v.y() * v.y()) - d), bound);
    const Vector2 u = Normalize(v);
    const auto seeUnit = [&](CWorst& worst, const Vector2& is) {
      worst.See(abs(is.x() - e.x / d), g_fUlp * abs(e.x / d) + CFifty(0x1p-149));
      worst.See(abs(is.y() - e.y / d), g_fUlp * abs(e.y / d) + CFifty(0x1p-149));
    };
    seeUnit(unit, u);
    seeUnit(quotient, v / std::sqrt(v.x() * v.x() + v.y() * v.y()));
    one.See(abs(Norm(Exact(u)) - 1), g_fUlp);
  }
  length.ExpectKept(9000);
  unit.ExpectKept(9000);
  one.ExpectKept(9000);
  squares.ExpectBroken();
  quotient.ExpectBroken();
}

TEST(ShapeMathBounds, ParallelComponent) {
  CRandom random(1003);
  CWorst worst("ParallelComponent"), naive("ParallelComponent by w.w");
  for (int i = 0; i < g_nShapeMathBoundsTrials; ++i) {
    const Vector2 v = AnyWay(random, AnySize(random));
    const Vector2 w = i % 2 ? AnyVector(random, -140, 120) : Vector2(NearOne(random) * perp(v));
    if (w == Vector2::Zero()) continue;
    const CVec ev = Exact(v), ew = Exact(w), exact = (Dot(ev, ew) / Dot(ew, ew)) * ew;
    worst.See(Exact(ParallelComponent(v, w)), exact, 3 * g_fUlp * Norm(ev));
    naive.See(Exact(Vector2((v.dot(w) / w.dot(w)) * w)), exact, 3 * g_fUlp * Norm(ev));
  }
  worst.ExpectKept(9000);
  naive.ExpectBroken();
}

TEST(ShapeMathBounds, RotatePt) {
  CRandom random(1004);
  CWorst worst("RotatePt"), naive("RotatePt in float");
  for (int i = 0; i < g_nShapeMathBoundsTrials; ++i) {
    const float size = AnySize(random);
    const Vector2 center = AnyPlace(random, size);
    const Vector2 p = center + AnyWay(random, size);
    const float angle = i % 50 ? AnyAngle(random) : random.SignedScale(10, 120);
    const CVec exact = Turned(Exact(p), Exact(center), angle);
    const CFifty bound = g_fUlp * (Norm(Exact(center)) + Gap(Exact(p), Exact(center)));
    worst.See(Exact(RotatePt(p, center, angle)), exact, bound);
    // About the origin, then to where the centre belongs.
    const float c = std::cos(angle), s = std::sin(angle);
    const auto turned = [&](const Vector2& v) {
      return Vector2(c * v.x() - s * v.y(), s * v.x() + c * v.y());
    };
    naive.See(Exact(Vector2(turned(p) + (center - turned(center)))), exact, bound);
  }
  worst.ExpectKept(g_nShapeMathBoundsTrials);
  naive.ExpectBroken();
}

TEST(ShapeMathBounds, NormalizeAngle) {
  CRandom random(1005);
  CWorst worst("NormalizeAngle"), naive("NormalizeAngle in float");
  for (int i = 0; i < g_nShapeMathBoundsTrials; ++i) {
    float angle = i % 2 ? AnyAngle(random) : random.SignedScale(-20, 28);
    if (i % 4 == 0) {
      const int exponent = static_cast<int>(random.Below(28));
      const float turns = std::round(random.SignedScale(0, exponent));
      angle = Neighbour(random, static_cast<float>(static_cast<double>(turns) * 6.283185307179586), 2);
    }
    const CFifty exact = Turn(angle);
    const auto see = [&](CWorst& w, float is) {
      // What is so close below a whole turn that it rounds to it becomes 0.
      if (is == 0.0f && exact > 6) return w.See(2 * Pi() - exact, g_fUlp);
      w.See(abs(is - exact), g_fUlp * exact);
    };
    const float got = NormalizeAngle(angle);
    ASSERT_TRUE(got >= 0.0f && CFifty(got) < 2 * Pi()) << angle;
    see(worst, got);
    const float rest = std::fmod(angle, g_fTwoPi);
    see(naive, rest < 0.0f ? rest + g_fTwoPi : rest);
  }
  worst.ExpectKept(g_nShapeMathBoundsTrials);
  naive.ExpectBroken();
}

TEST(ShapeMathBounds, AngleToVector) {
  CRandom random(1006);
  CWorst worst("AngleToVector"), naive("AngleToVector by a root");
  for (int i = 0; i < g_nShapeMathBoundsTrials; ++i) {
    const float angle = i % 50 ? AnyAngle(random) : random.SignedScale(10, 120);
    const CVec exact = AtAngle(angle);
    const auto see = [&](CWorst& w, const Vector2& is) {
      w.See(abs(is.x() - exact.x), g_fUlp * abs(exact.x));
      w.See(abs(is.y() - exact.y), g_fUlp * abs(exact.y));
    };
    see(worst, AngleToVector(angle));
    const float c = std::cos(angle);
    see(naive, {c, std::copysign(std::sqrt(1.0f - c * c), std::sin(angle))});
  }
  worst.ExpectKept(g_nShapeMathBoundsTrials);
  naive.ExpectBroken();
}

} // namespace
} // namespace Shapes::Bounds
