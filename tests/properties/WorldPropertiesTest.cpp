// SPDX-License-Identifier: MIT
// The native world, on both of its ways through a substep: from impact to impact, and by what overlaps at the
// end.
#include "../bounds/Inputs.h"
#include "Drawn.h"
#include "Moved.h"
#include "Properties.h"

namespace Shapes::Properties {
namespace {

struct CScene {
  std::vector<CAnyShapeDesc> m_stdShapes;
  std::vector<CDynamicCircleDesc> m_stdBalls;
  Vector2 m_vGravity = Vector2::Zero();
};

/// Where all balls are after some steps, and how fast.
struct CState {
  std::vector<Vector2> m_stdPos, m_stdVel;
  std::uint64_t m_nContacts = 0;
  friend bool operator==(const CState&, const CState&) = default;
};

CState Play(const CScene& scene, bool continuous, int steps = 20, float dt = 0x1p-6f) {
  CWorldDesc desc;
  desc.m_vGravity = scene.m_vGravity;
  desc.m_fTimeStep = dt;
  desc.m_cEffects = continuous ? g_cContinuous : g_cApproximate;
  const std::unique_ptr<CWorld> pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
  for (const CAnyShapeDesc& shape : scene.m_stdShapes)
    pWorld->Add(shape);
  for (const CDynamicCircleDesc& ball : scene.m_stdBalls)
    pWorld->Add(ball);
  Steps(*pWorld, steps);
  const auto pos = pWorld->GetBallPositions(), vel = pWorld->GetBallVelocities();
  return {{pos.begin(), pos.end()}, {vel.begin(), vel.end()}, pWorld->GetStats().m_nContacts};
}

CScene Moved(CScene scene, const CMap& map) {
  for (CAnyShapeDesc& shape : scene.m_stdShapes)
    shape = Moved(shape, map);
  for (CDynamicCircleDesc& ball : scene.m_stdBalls)
    ball = std::get<CDynamicCircleDesc>(Moved(CAnyShapeDesc(ball), map));
  scene.m_vGravity = map.Way(scene.m_vGravity);
  return scene;
}
CState Moved(CState state, const CMap& map) {
  for (Vector2& p : state.m_stdPos)
    p = map.Pt(p);
  for (Vector2& v : state.m_stdVel)
    v = map.Way(v);
  return state;
}

// Shapes that can be turned and mirrored bit for bit: no arcs, and segments that fall from left to right if
// `falling`.
CAnyShapeDesc AnyShape(const Vector2& p, float size, bool falling) {
  const float e = g_cDrawn.Uniform(0.5f, 1.0f);
  switch (g_cDrawn.Below(3)) {
  case 0: return CPointDesc(p, e);
  case 1: return CCircleDesc(p, g_cDrawn.Uniform(0.05f, 0.5f) * size, e);
  default: {
    const float x = g_cDrawn.Uniform(0.05f, 0.5f), y = g_cDrawn.Uniform(0.05f, 0.5f);
    const bool falls = falling || g_cDrawn.Coin();
    const Vector2 half = size * Vector2(x, falls ? -y : y);
    return CLineSegDesc(p - half, p + half, e);
  }
  }
}

// Balls and shapes of about 1 in a square of 8, in each other's way.
CScene Crowd(bool falling) {
  CScene scene;
  for (std::uint32_t k = 1 + g_cDrawn.Below(7); k > 0; --k)
    scene.m_stdShapes.push_back(AnyShape(g_cDrawn.InSquare(4.0f), 3.0f, falling));
  for (std::uint32_t k = 1 + g_cDrawn.Below(5); k > 0; --k) {
    const Vector2 p = g_cDrawn.InSquare(4.0f), v = Bounds::AnyWay(g_cDrawn, g_cDrawn.Scale(-4, 4));
    const float r = g_cDrawn.Uniform(0.05f, 0.5f), m = g_cDrawn.Scale(-3, 3);
    scene.m_stdBalls.emplace_back(p, r, v, m, g_cDrawn.Uniform(0.5f, 1.0f));
  }
  scene.m_vGravity = g_cDrawn.Coin() ? Vector2(Vector2::Zero()) : Bounds::AnyWay(g_cDrawn, 9.81f);
  return scene;
}

// One shape in four moves, and turns if it `turns`.
CScene Driven(CScene scene, bool turns) {
  for (CAnyShapeDesc& shape : scene.m_stdShapes) {
    if (g_cDrawn.Below(4) > 0) continue;
    const float speed = turns ? g_cDrawn.Uniform(-2.0f, 2.0f) : 0.0f;
    const Vector2 center = g_cDrawn.InSquare(4.0f), v = g_cDrawn.InSquare(2.0f);
    std::visit(
        [&](auto& d) {
          d = Turning(d, speed, center);
          d.m_vVel = v;
        },
        shape);
  }
  return scene;
}

// With arcs, and shapes that turn.
CScene TurningCrowd() {
  CScene scene = Crowd(false);
  for (std::uint32_t k = g_cDrawn.Below(3); k > 0; --k) {
    const Vector2 p = g_cDrawn.InSquare(4.0f);
    // No ends that are next to an axis: a power of two is not exact for denormals.
    const float r = g_cDrawn.Uniform(0.3f, 2.0f), a0 = g_cDrawn.Uniform(0.1f, 6.2f),
                a1 = g_cDrawn.Uniform(0.1f, 6.2f);
    scene.m_stdShapes.emplace_back(CArcDesc(p, r, a0, a1));
  }
  return Driven(scene, true);
}

// The control of bits that do not depend on the unit or the direction: a push by an amount of its own.
CScene Pushed(CScene scene) {
  for (CDynamicCircleDesc& ball : scene.m_stdBalls)
    ball.m_vPos += Vector2(1e-3f, 2e-3f);
  return scene;
}

class WorldProperties : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(, WorldProperties, testing::Bool(),
                         [](const auto& test) { return test.param ? "Continuous" : "Approximate"; });

TEST_P(WorldProperties, APowerOfTwoScalesTheBits) {
  ExpectHolds(false, true, 4000, [](bool pushed) {
    const CScene scene = TurningCrowd();
    CMap map;
    map.m_fScale = std::ldexp(1.0f, g_cDrawn.Whole(-20, 20));
    const CScene scaled = Moved(scene, map);
    RC_ASSERT(Play(pushed ? Pushed(scaled) : scaled, GetParam()) ==
              Moved(Play(pushed ? Pushed(scene) : scene, GetParam()), map));
  });
}

TEST_P(WorldProperties, AQuarterTurnAndAMirrorKeepTheBits) {
  ExpectHolds(false, true, 4000, [](bool pushed) {
    const CScene scene = Driven(Crowd(true), false);
    CMap turned, mirrored;
    turned.m_pTurn = Quarter;
    mirrored.m_pTurn = MirrorY;
    const CState state = Play(pushed ? Pushed(scene) : scene, GetParam());
    for (const CMap& map : {turned, mirrored}) {
      const CScene other = Moved(scene, map);
      RC_ASSERT(Play(pushed ? Pushed(other) : other, GetParam()) == Moved(state, map));
    }
  });
}

// Between walls along the axes, at places and speeds whose sums are exact, a perfect ball goes the same way
// wherever it all is: bit for bit where it is looked at at the end of steps, and within the rounding of the
// place where the time of the impact comes between.
TEST_P(WorldProperties, AMoveMovesTheGame) {
  ExpectHolds(false, true, 4000, [](bool slanted) {
    const auto grid = [](int most, float unit) {
      const int x = g_cDrawn.Whole(-most, most), y = g_cDrawn.Whole(-most, most);
      return Vector2(unit * Vector2(static_cast<float>(x), static_cast<float>(y)));
    };
    CScene scene;
    const float w = slanted ? 0.3f : 0.0f;
    for (const auto& [p, q] :
         {std::pair{Vector2(-4, -4), Vector2(4, -4 + w)}, std::pair{Vector2(-4, 4), Vector2(4, 4)},
          std::pair{Vector2(-4, -4), Vector2(-4, 4)}, std::pair{Vector2(4, -4), Vector2(4, 4)}})
      scene.m_stdShapes.emplace_back(CLineSegDesc(p, q));
    const Vector2 p = grid(3 << 6, 0x1p-6f), v = grid(1 << 9, 0x1p-2f);
    scene.m_stdBalls.emplace_back(p, 0.25f, v);
    CMap map;
    map.m_vShift = grid(1 << 9, 1.0f);
    map.m_vShift += slanted ? Vector2(0.1f, 0.1f) : Vector2(0.0f, 0.0f);
    const CState is = Play(Moved(scene, map), GetParam(), 40),
                 should = Moved(Play(scene, GetParam(), 40), map);
    RC_ASSERT(is.m_nContacts == should.m_nContacts);
    RC_ASSERT(is.m_stdVel == should.m_stdVel);
    // 40 steps round the place to half an ulp of each coordinate, here and there; what is computed in
    // double in between is below that.
    const double size = Wide(map.m_vShift).norm() + 6.0, bound = GetParam() ? 40 * g_fUlp * size : 0.0;
    RC_ASSERT((Wide(is.m_stdPos[0]) - Wide(should.m_stdPos[0])).norm() <= bound);
  });
}

// Cells of 6, each with one shape that reaches no farther than 1.5 from its middle: no ball touches two.
CScene Apart(float cell) {
  CScene scene;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      scene.m_stdShapes.push_back(
          AnyShape(cell * Vector2(static_cast<float>(x), static_cast<float>(y)), 2.0f, false));
  for (std::uint32_t k = 1 + g_cDrawn.Below(5); k > 0; --k) {
    const Vector2 p = g_cDrawn.InSquare(1.5f * cell), v = Bounds::AnyWay(g_cDrawn, g_cDrawn.Scale(-4, 4));
    const float r = g_cDrawn.Uniform(0.05f, 0.5f);
    scene.m_stdBalls.emplace_back(p, r, v, 1.0f, 0.9f);
  }
  return scene;
}

std::vector<CAnyShapeDesc> Shuffled(std::vector<CAnyShapeDesc> shapes) {
  for (std::size_t k = shapes.size(); k > 1; --k)
    std::swap(shapes[k - 1], shapes[g_cDrawn.Below(static_cast<std::uint32_t>(k))]);
  return shapes;
}

TEST_P(WorldProperties, TheOrderOfShapesThatAreApartDoesNotMatter) {
  const auto holds = [](bool apart) {
    return [=] {
      // The control has them all in a heap, where whoever comes first is met first.
      CScene scene = apart ? Apart(6.0f) : Apart(0.2f);
      const CState state = Play(scene, GetParam(), 60);
      scene.m_stdShapes = Shuffled(scene.m_stdShapes);
      RC_ASSERT(Play(scene, GetParam(), 60) == state);
    };
  };
  ExpectHolds(holds(true), 3000);
  if (!GetParam()) ExpectBroken(holds(false)); // where the earliest impact comes first, whatever the order
}

// Points are met before what they guard, wherever they stand among the others.
TEST_P(WorldProperties, TheOrderOfPointsAmongWhatTheyGuardDoesNotMatter) {
  const auto holds = [](bool points) {
    return [=] {
      CScene scene = Crowd(false);
      std::vector<CAnyShapeDesc> guards, others;
      for (const CAnyShapeDesc& shape : scene.m_stdShapes) {
        const auto* pSeg = std::get_if<CLineSegDesc>(&shape);
        if (pSeg == nullptr) continue;
        others.push_back(shape);
        for (const Vector2& end : {pSeg->GetEndPt0(), pSeg->GetEndPt1()}) {
          // The control guards by tiny circles, which are met when their turn comes.
          if (points)
            guards.emplace_back(CPointDesc(end));
          else
            guards.emplace_back(CCircleDesc(end, 0x1p-10f));
        }
      }
      scene.m_stdShapes = guards;
      scene.m_stdShapes.insert(scene.m_stdShapes.end(), others.begin(), others.end());
      const CState state = Play(scene, GetParam());
      // Any way to put the one between the other, each in its order.
      scene.m_stdShapes.clear();
      std::size_t g = 0, o = 0;
      while (g < guards.size() || o < others.size()) {
        const bool guard = o == others.size() || (g < guards.size() && g_cDrawn.Coin());
        scene.m_stdShapes.push_back(guard ? guards[g++] : others[o++]);
      }
      RC_ASSERT(Play(scene, GetParam()) == state);
    };
  };
  ExpectHolds(holds(true), 4000);
  if (!GetParam()) ExpectBroken(holds(false));
}

// Without gravity and turning shapes, and with an elasticity of at most 1, no ball gets faster than all of
// them were, and the energy does not grow: each of the contacts rounds a speed as Response.h says.
TEST_P(WorldProperties, NoEnergyIsGained) {
  ExpectHolds(1.0f, 2.5f, 4000, [](float e) {
    CScene scene = Crowd(false);
    scene.m_vGravity.setZero();
    double before = 0.0;
    for (CDynamicCircleDesc& ball : scene.m_stdBalls) {
      ball.m_fElasticity *= e;
      before += static_cast<double>(ball.m_fMass) * Wide(ball.m_vVel).squaredNorm();
    }
    const CState state = Play(scene, GetParam());
    double after = 0.0;
    for (std::size_t k = 0; k < state.m_stdVel.size(); ++k)
      after += static_cast<double>(scene.m_stdBalls[k].m_fMass) * Wide(state.m_stdVel[k]).squaredNorm();
    // Weighed by the root of its mass, no speed is larger than the root of the energy, and no
    // share of a relative speed than 1.5 of it. By the bounds of Response.h, a contact adds at
    // most 5 (1 + 2 * 1.5) + 3 * 2 * 1.5 = 29 ulp of that to each of two balls.
    const double share = 2 * 29 * g_fUlp * static_cast<double>(state.m_nContacts);
    RC_ASSERT(std::sqrt(after) <= std::sqrt(before) * (1 + share));
  });
}

} // namespace
} // namespace Shapes::Properties
