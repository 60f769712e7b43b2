// SPDX-License-Identifier: MIT
// Random closed rooms full of balls, in which shapes of every kind rest, move, turn, are dragged and dropped,
// and a game steers, blows up, teleports, adds and removes: none loses a ball. SHAPES_GAMES says how many,
// 200 by default. Box2D loses balls in 66 of the first 400, 338 in all.
#include "RoomOutline.h"

namespace Shapes {
namespace {

/// A polygon about the origin, or a ring, with pegs, moving shapes and balls in it.
class CRandomGame : CRoomOutline {
public:
  CRandomGame(CRandom& random, const CEffectChoice& effects) : m_cRandom(random) {
    m_fSize = random.Uniform(1.5f, 3.0f);
    const float gravity = random.Below(4) == 0 ? 0.0f : random.Uniform(1, 20);
    const float dt = random.Below(4) == 0 ? random.Uniform(0.02f, 0.1f) : random.Scale(-9, -6);
    m_pWorld = MakeNative(effects, gravity, dt, random.Below(4) == 0 ? 1 + random.Below(8) : 1);
    AddWalls();
    for (std::uint32_t pegs = random.Below(4); pegs > 0; --pegs)
      AddInside(false);
    for (std::uint32_t movers = random.Below(4); movers > 0; --movers)
      AddInside(true);
    m_fSmallest = random.Uniform(0.03f, 0.1f);
    m_fLargest = random.Coin() ? m_fSmallest : m_fSmallest * random.Uniform(1, 8);
    m_nHeaviest = random.Coin() ? 0 : 10;
    m_fBallElasticity = random.Below(3) == 0 ? 1.0f : random.Uniform(0, 1);
    for (std::uint32_t balls = 1 + random.Below(random.Coin() ? 20 : 100), i = 0; i < balls; ++i)
      AddBall();
    for (const CShapeId ball : m_pWorld->GetBallIds())
      m_pWorld->SetVel(ball, random.VectorOfLength(0, 6));
    m_nMoves = random.Below(1u << eMove_N);
  }

  /// One step, before which a game may do something.
  void Step() {
    DriveMovers();
    if (m_cRandom.Below(8) == 0) Play();
    m_pWorld->Step();
  }

  /// The balls that are outside.
  std::size_t CountLost() const {
    return static_cast<std::size_t>(
        CountBalls(*m_pWorld, [&](const Vector2& p) { return !(GetDepthInside(p) >= -2e-6); }));
  }

private:
  enum eMove { Steer, BlowUp, Teleport, Change, Drag, TurnGravity, Filter, Toggle, eMove_N };

  void AddWalls() {
    const float e = m_cRandom.Uniform(0, 1);
    const bool isOneSided = m_cRandom.Below(3) == 0, isKinematic = m_cRandom.Below(5) == 0;
    if (m_cRandom.Below(7) != 0) AddCorners();
    ForEachWall(e, [&](auto wall, eSides inside) {
      if (isOneSided) wall.m_eSides = inside;
      m_pWorld->Add(isKinematic ? Turning(wall) : wall);
    });
  }

  void AddCorners() {
    const std::uint32_t corners = 3 + m_cRandom.Below(6);
    for (std::uint32_t i = 0; i < corners; ++i) {
      const float turn =
          (static_cast<float>(i) + m_cRandom.Uniform(-0.25f, 0.25f)) / static_cast<float>(corners);
      m_stdCorners.push_back(m_fSize * AngleToVector(2 * g_fPi * turn));
    }
  }

  /// A shape of any kind, at rest or moving.
  void AddInside(bool isMoving) {
    const Vector2 p = m_cRandom.InSquare(0.7f * m_fSize);
    const std::uint32_t kind = m_cRandom.Below(4);
    WithAnyShape(m_cRandom, kind, p, 0.6f * m_fSize, [&](auto desc) {
      desc.m_fElasticity = m_cRandom.Uniform(0, 1);
      if constexpr (requires { desc.m_eSides; })
        if (m_cRandom.Below(6) == 0) desc.m_eSides = m_cRandom.Coin() ? eSides::Front : eSides::Back;
      if (!isMoving) {
        m_stdPegs.push_back(m_pWorld->Add(desc));
        return;
      }
      const float revs = m_cRandom.Coin() ? m_cRandom.SignedScale(-4, 2) : 0.0f;
      desc = Turning(desc, revs, p + m_cRandom.InSquare(m_cRandom.Coin() ? 0.0f : 0.5f));
      if (m_cRandom.Coin()) desc.m_vVel = m_cRandom.Vector(-3, 4);
      m_stdMovers.push_back(m_pWorld->Add(desc));
    });
  }

  void AddBall() {
    const float radius = std::min(m_cRandom.Uniform(m_fSmallest, m_fLargest), 0.2f * m_fSize);
    const float mass = m_cRandom.Scale(0, m_nHeaviest);
    if (const auto place = FindPlace(radius))
      m_pWorld->Add(CDynamicCircleDesc(*place, radius, {0, 0}, mass, m_fBallElasticity));
  }
  /// Within the walls for a ball of this radius, maybe in other shapes and balls.
  std::optional<Vector2> FindPlace(float radius) {
    for (int attempt = 0; attempt < 50; ++attempt)
      if (const Vector2 p = m_cRandom.InSquare(m_fSize); GetDepthInside(p) > 1.01f * radius) return p;
    return {};
  }

  /// They turn round before they leave the room.
  void DriveMovers() {
    for (const CShapeId id : m_stdMovers)
      if (const Vector2 v = m_pWorld->GetVel(id), p = m_pWorld->GetPos(id);
          p.dot(v) > 0 && p.norm() > 0.8f * m_fSize)
        m_pWorld->SetVel(id, -v);
  }

  bool Does(eMove move) { return (m_nMoves >> move & 1u) != 0 && m_cRandom.Below(4) == 0; }
  CShapeId Any(const std::vector<CShapeId>& ids) {
    return ids[m_cRandom.Below(static_cast<std::uint32_t>(ids.size()))];
  }
  CShapeId AnyBall() {
    const auto balls = m_pWorld->GetBallIds();
    return balls[m_cRandom.Below(static_cast<std::uint32_t>(balls.size()))];
  }

  void Play() {
    CWorld& world = *m_pWorld;
    if (world.GetBallIds().empty()) return;
    if (Does(Steer)) {
      const CShapeId ball = AnyBall();
      world.SetVel(ball, m_cRandom.Vector(-2, 6));
    }
    if (Does(BlowUp)) {
      const Vector2 center = m_cRandom.InSquare(m_fSize);
      const float speed = m_cRandom.Scale(-1, 5);
      for (const CShapeId ball : world.FindInCircle(center, 1))
        if (world.GetMotionType(ball) == eMotion::Dynamic)
          world.SetVel(ball, world.GetVel(ball) + speed * (world.GetPos(ball) - center));
    }
    if (Does(Teleport)) {
      const CShapeId ball = AnyBall();
      if (const auto place = FindPlace(world.GetRadius(ball))) world.SetPos(ball, *place);
    }
    if (Does(Change)) {
      world.Remove(AnyBall());
      AddBall();
    }
    if (Does(Drag) && !m_stdMovers.empty()) {
      const CShapeId mover = Any(m_stdMovers);
      world.SetPos(mover, world.GetPos(mover) * 0.9f + m_cRandom.InSquare(0.2f));
    }
    if (Does(TurnGravity)) world.SetGravity(m_cRandom.VectorOfLength(0, 20));
    if (Does(Filter) && !world.GetBallIds().empty()) {
      const CFilter ghost{0x0002, 0x0001}; // meets everything but its like
      const CShapeId ball = AnyBall();
      world.SetFilter(ball, m_cRandom.Coin() ? ghost : CFilter());
    }
    if (Does(Toggle) && !m_stdPegs.empty()) {
      const CShapeId peg = Any(m_stdPegs);
      if (m_cRandom.Coin())
        world.SetSensor(peg, !world.GetSensor(peg));
      else
        world.SetCanCollide(peg, !world.GetCanCollide(peg));
    }
  }

  CRandom& m_cRandom;
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdPegs, m_stdMovers;
  float m_fSmallest, m_fLargest, m_fBallElasticity;
  int m_nHeaviest;
  std::uint32_t m_nMoves; // those that this game makes, a bit for each
};

constexpr int g_nSteps = 120;

/// The most balls that are out after a step: a game may bring back or remove one.
std::size_t PlayGame(std::uint64_t seed, const CEffectChoice& effects) {
  CRandom random(seed);
  CRandomGame game(random, effects);
  std::size_t lost = 0;
  for (int step = 0; step < g_nSteps; ++step) {
    game.Step();
    lost = std::max(lost, game.CountLost());
  }
  return lost;
}

TEST(RandomGames, LoseNoBall) {
  const std::uint64_t games = HowMany("SHAPES_GAMES", 200);
  // Balls came out of one-sided walls as others pressed them deeper into these, in the first two; out of a
  // shape along a curve through the next wall, in the next two; and through walls as a game put a shape
  // there, or stopped one. In the last one a pile took a ball through the wall that held it.
  std::vector<std::uint64_t> seeds = {1120, 1619, 5999, 9692, 8700, 1041, 2702, 3541, 8210};
  for (std::uint64_t seed = 0; seed < games; ++seed)
    seeds.push_back(seed);
  for (const std::uint64_t seed : seeds)
    EXPECT_EQ(PlayGame(seed, g_cAutomatic), 0u) << "seed " << seed;
}

TEST(RandomGames, LoseBallsInTheApproximateMode) { // the control
  std::size_t lost = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    lost += PlayGame(seed, g_cApproximate);
  EXPECT_GT(lost, 20u);
}

} // namespace
} // namespace Shapes
