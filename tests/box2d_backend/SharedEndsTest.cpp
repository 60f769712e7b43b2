// SPDX-License-Identifier: MIT
// Which ends go on in another shape, and how.
#include "box2d_backend/world/SharedEnds.h"

#include "Box2DTesting.h"

namespace Shapes::Tests {
namespace {

using Box2D::CSharedEnd;
using Box2D::CSharedEnds;
using Box2D::FindSharedEnds;

constexpr float g_fTolerance = 0.005f;

/// Shapes with the ids 1, 2, ... as a world holds them.
class CTable {
public:
  CShapeId Add(std::unique_ptr<CShape> pShape) {
    const CShapeId id{m_cState.m_nNextId++};
    m_cState.m_stdShapes.emplace_back(id, std::move(pShape));
    return id;
  }
  CShapeId Segment(const Vector2& p0, const Vector2& p1) { return Add(MakeShape(CLineSegDesc(p0, p1))); }
  CShapeId Arc(const Vector2& c, float r, float a0, float a1) {
    return Add(MakeShape(CArcDesc(c, r, a0, a1)));
  }
  CShape& Get(CShapeId id) { return *m_cState.m_stdShapes[m_cState.FindShape(id)].m_pShape; }

  std::map<CShapeId, CSharedEnds> Find() const { return FindSharedEnds(m_cState, g_fTolerance); }
  std::size_t Count() const {
    std::size_t n = 0;
    for (const auto& [id, sharedEnds] : Find())
      n += sharedEnds[0].has_value() + sharedEnds[1].has_value();
    return n;
  }

private:
  CWorldState m_cState;
};

/// The segment that goes on beyond an end; fails if none does.
CSharedEnd At(const CTable& table, CShapeId id, std::size_t end) {
  const auto joint = table.Find()[id][end];
  EXPECT_TRUE(joint) << "shape " << id.m_nValue << " has no joint at end " << end;
  return joint.value_or(CSharedEnd());
}

void ExpectJoint(const CSharedEnd& joint, CShapeId neighbour, const Vector2& tangent, float bend) {
  EXPECT_EQ(joint.m_cNeighbour, neighbour);
  EXPECT_LE((joint.m_vTangent - tangent).norm(), 4 * g_fUlp);
  EXPECT_EQ(joint.m_fBend, bend);
}

/// The shared ends of two shapes: 2 if they join.
std::size_t CountOf(const CAnyShapeDesc& first, const CAnyShapeDesc& second) {
  CTable table;
  table.Add(MakeShape(first));
  table.Add(MakeShape(second));
  return table.Count();
}

TEST(JointsTest, EndsCountAsOneWithinTheTolerance) {
  const CLineSegDesc first({-2, -2}, {0, 0});
  for (const Vector2& u : {Vector2(1, 0), Vector2(-1, 0), Vector2(0, 1), Vector2(0.6f, -0.8f)}) {
    EXPECT_EQ(CountOf(first, CLineSegDesc(0.9f * g_fTolerance * u, {2, -2})), 2u) << u;
    EXPECT_EQ(CountOf(first, CLineSegDesc(1.1f * g_fTolerance * u, {2, -2})), 0u) << u;
  }
}

TEST(JointsTest, WhereThreeMeetNoneIsJoined) {
  CTable table;
  const CShapeId a = table.Segment({-1, 0}, {0, 0}), b = table.Segment({0, 0}, {1, 0});
  EXPECT_EQ(table.Count(), 2u);
  const CShapeId c = table.Segment({0, 0}, {0, 1});
  EXPECT_EQ(table.Count(), 0u);
  table.Segment({1, 0}, {2, 1}); // elsewhere two of them do
  ExpectJoint(At(table, b, 1), CShapeId{4}, Vector2(1, 1).normalized(), 0);
  EXPECT_EQ(table.Count(), 2u);
  // A segment that cannot be met does not count.
  table.Get(c).SetCanCollide(false);
  ExpectJoint(At(table, a, 1), b, {1, 0}, 0);
  table.Get(c).SetCanCollide(true);
  table.Get(c).SetSensor(true);
  ExpectJoint(At(table, a, 1), b, {1, 0}, 0);
  // Nor is it joined itself.
  table.Get(a).SetSensor(true);
  EXPECT_FALSE(table.Find()[b][0]);
  table.Get(a).SetSensor(false);
  table.Get(a).SetCanCollide(false);
  EXPECT_FALSE(table.Find()[b][0]);
}

TEST(JointsTest, OnlyWhatMovesTogetherIsJoined) {
  const CLineSegDesc left({-1, 0}, {0, 0}), right({0, 0}, {1, 0});
  const CLineSegDesc turning = Turning(left, 2, {0.5f, 0.5f}), moving = Moving(left, {1, 0});
  EXPECT_EQ(CountOf(turning, Turning(right, 2, {0.5f, 0.5f})), 2u);
  EXPECT_EQ(CountOf(turning, Turning(right, -2, {0.5f, 0.5f})), 0u);
  EXPECT_EQ(CountOf(turning, Turning(right, 2, {0.5f, 0.4f})), 0u);
  EXPECT_EQ(CountOf(moving, Turning(right)), 0u);
  EXPECT_EQ(CountOf(moving, Moving(right, {1, 0})), 2u);
  EXPECT_EQ(CountOf(Turning(left), right), 0u); // though it stands still
}

TEST(JointsTest, TangentsAreThoseOfNow) {
  CTable table;
  const CShapeId a = table.Add(MakeShape(Turning(CLineSegDesc({-1, 0}, {0, 0}), 1))),
                 b = table.Add(MakeShape(Turning(CLineSegDesc({0, 0}, {1, 1}), 1)));
  for (const CShapeId id : {a, b})
    table.Get(id).SetOrientation(g_fPi); // the ends change places
  ExpectJoint(At(table, a, 0), b, Vector2(-1, -1).normalized(), 0);
  ExpectJoint(At(table, b, 1), a, {1, 0}, 0);
}

TEST(JointsTest, SolidSidesGoOnInSolidSidesAlongTheWay) {
  const CLineSegDesc left({-1, 0}, {0, 0}), right({0, 0}, {1, 0}), up({0, 0}, {1, 1}), down({0, 0}, {1, -1});
  for (const eSides first : {eSides::Both, eSides::Front, eSides::Back})
    for (const eSides second : {eSides::Both, eSides::Front, eSides::Back})
      EXPECT_EQ(CountOf(Sided(left, first), Sided(right, second)), first == second ? 2u : 0u);
  // Two segments that fold back: both fronts are above, but one follows the way and one does not.
  EXPECT_EQ(CountOf(Sided(up, eSides::Front), Sided(down, eSides::Front)), 0u);
  EXPECT_EQ(CountOf(Sided(up, eSides::Front), Sided(down, eSides::Back)), 2u);
  // A floor whose front is above goes on in the inside of a bowl, or in the outside of a hill.
  const CLineSegDesc floor = Sided(left, eSides::Front);
  const CArcDesc bowl({0, 1}, 1, 1.5f * g_fPi, 0), hill({0, -1}, 1, 0, 0.5f * g_fPi);
  EXPECT_EQ(CountOf(floor, Sided(bowl, eSides::Back)), 2u);
  EXPECT_EQ(CountOf(floor, Sided(bowl, eSides::Front)), 0u);
  EXPECT_EQ(CountOf(floor, Sided(hill, eSides::Front)), 2u);
  EXPECT_EQ(CountOf(floor, Sided(hill, eSides::Back)), 0u);
}

TEST(JointsTest, TheBendLeadsAlongTheNeighbour) {
  // From the end along the tangent, with that curvature: that is where the arc is.
  int found = 0;
  ForEachCase(63, 2000, [&](CRandom& random, int) {
    CTable table;
    const float R = random.Scale(-2, 3), a0 = random.Uniform(0, 6.28f), span = random.Uniform(0.5f, 6);
    const Vector2 c = random.InSquare(10);
    const CShapeId id = table.Arc(c, R, a0, a0 + span);
    const auto& arc = static_cast<const CArc&>(table.Get(id));
    const std::size_t end = random.Below(2);
    const Vector2 p = end == 0 ? arc.GetEndPt0() : arc.GetEndPt1();
    const Vector2 along = random.VectorOfLength(1, 2);
    const CShapeId seg = table.Segment(p, p + along);
    const CSharedEnds ofSeg = table.Find()[seg];
    if (!ofSeg[0] && !ofSeg[1]) return; // the other end of the arc is too near
    ++found;
    const CSharedEnd& joint = ofSeg[0] ? *ofSeg[0] : *ofSeg[1];
    EXPECT_EQ(joint.m_cNeighbour, id);
    const double bend = joint.m_fBend, s = 0.1;
    const Vector2d t = Wide(joint.m_vTangent);
    const Vector2d there = Wide(p) + std::sin(s) / std::abs(bend) * t + (1 - std::cos(s)) / bend * Perp(t);
    EXPECT_NEAR((there - Wide(c)).norm(), R, 16e-7 * (10 + Wide(R)));
    EXPECT_TRUE(arc.PtInSector(there.cast<float>()));
    const CSharedEnd& ofArc = At(table, id, end);
    EXPECT_EQ(ofArc.m_cNeighbour, seg);
    EXPECT_LE((ofArc.m_vTangent - along.normalized()).norm(), 16e-7f * (10 + R));
    EXPECT_EQ(ofArc.m_fBend, 0);
  });
  EXPECT_GT(found, 1900);
}

TEST(JointsTest, FullCirclesAndWhatHasNoLengthHaveNoEnds) {
  CTable table;
  table.Arc({0, 0}, 1, 0, 0);
  table.Segment({1, 0}, {2, 0});
  table.Segment({2, 0}, {2, 0});
  table.Arc({2, 0}, 0, 0, 1);
  table.Arc({5, 0}, 1, 1.002f, 1.001f); // its own ends are one
  EXPECT_EQ(table.Count(), 0u);
  table.Segment({2, 1}, {2, 2}); // the control
  table.Segment({2, 2}, {3, 2});
  EXPECT_EQ(table.Count(), 2u);
}

TEST(JointsTest, TheOrderInWhichTheyWereAddedDoesNotMatter) {
  // A closed chain of 12 segments and arcs, by their numbers, and the same in random orders.
  const auto make = [](const std::vector<std::uint32_t>& order) {
    CTable table;
    for (const std::uint32_t i : order) {
      const float a0 = g_fTwoPi * static_cast<float>(i) / 12, a1 = g_fTwoPi * static_cast<float>(i + 1) / 12;
      Vector2 p0, p1;
      CArcDesc({1, 2}, 3, a0, a1).GetEndPts(p0, p1);
      i % 3 == 0 ? table.Segment(p0, p1) : table.Arc({1, 2}, 3, a0, a1);
    }
    std::vector<CSharedEnds> links(order.size());
    for (const auto& [id, sharedEnds] : table.Find()) {
      CSharedEnds& link = links[order[id.m_nValue - 1]] = sharedEnds;
      for (auto& joint : link)
        if (joint) joint->m_cNeighbour = CShapeId{order[joint->m_cNeighbour.m_nValue - 1]};
    }
    return links;
  };
  std::vector<std::uint32_t> order{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const std::vector<CSharedEnds> links = make(order);
  for (std::uint32_t i = 0; i < 12; ++i)
    for (const auto& joint : links[i]) {
      ASSERT_TRUE(joint) << i;
      const std::uint32_t step = (joint->m_cNeighbour.m_nValue + 12 - i) % 12;
      EXPECT_TRUE(step == 1 || step == 11) << i;
    }
  ForEachCase(64, 50, [&](CRandom& random, int) {
    for (std::size_t i = order.size() - 1; i > 0; --i)
      std::swap(order[i], order[random.Below(static_cast<std::uint32_t>(i + 1))]);
    const std::vector<CSharedEnds> others = make(order);
    for (std::size_t i = 0; i < links.size(); ++i)
      for (std::size_t end = 0; end < 2; ++end) {
        ASSERT_TRUE(others[i][end]);
        const CSharedEnd& joint = *links[i][end];
        ExpectJoint(*others[i][end], joint.m_cNeighbour, joint.m_vTangent, joint.m_fBend);
      }
  });
}

} // namespace
} // namespace Shapes::Tests
