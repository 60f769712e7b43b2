// SPDX-License-Identifier: MIT
#include "Ghosts.h"

#include "EngineResponse.h"
#include "reference/Distance.h"

#include <algorithm>
#include <exception>

namespace Shapes::Compare {
namespace {

// Steps after the quiet one in which the exact ball may still touch a shape to which an engine has responded.
constexpr int g_nLookAhead = 2;

// A shape nearer than this share of the radius counts as touched, also by a resting ball after all roundings.
constexpr double g_fTouching = 1e-3;

// A ball passes a shape that comes nearer than this to its surface, in its radii.
constexpr double g_fPass = 1.0;

// Ways are walked in pieces of at least this many radii, so that walking ends. Passes are found to that
// depth. And in so many pieces at most, if the ball is a point.
constexpr double g_fPiece = 0.125;
constexpr double g_fMostPieces = 4096.0;

// Whether the disc of this radius about a centre that moves from p0 to p1 meets the figure. As far as the
// figure is away the centre may move without meeting it.
bool Passes(const CShapeGeometry<double>& figure, const CVec2d& p0, const CVec2d& p1, double reach,
            double piece) {
  const double way = Norm(CVec2d(p1 - p0));
  for (double done = 0.0;;) {
    const CVec2d p = way > 0.0 ? CVec2d(p0 + (p1 - p0) * (done / way)) : p0;
    const double gap = Distance(figure, p) - reach;
    if (gap <= 0.0) return true;
    if (done >= way) return false;
    done = std::min(way, done + std::max({gap, piece, way / g_fMostPieces}));
  }
}

// The least distance from the origin of a point that moves from x0 to x1.
double LeastDistance(const CVec2d& x0, const CVec2d& x1) {
  CShapeGeometry<double> way;
  way.m_eShapeType = eShape::LineSeg;
  way.m_vPt0 = x0;
  way.m_vPt1 = x1;
  return Distance(way, CVec2d(CVec2d::Zero()));
}

} // namespace

CGhostHunter::CGhostHunter(const CScene& scene, const std::vector<CEngine>& engines)
    : m_cScene(scene), m_stdEngines(engines) {}

bool CGhostHunter::IsQuiet(const CExactGame& game, std::size_t ball) const {
  const CReference<double>& reference = game.GetReference();
  if (m_cScene.m_stdBalls[ball].m_cDesc.m_bIsSensor) return false;
  const double r = reference.GetBall(ball).m_fRadius;
  const CVec2d p0 = ToDouble(game.GetBalls()[ball].m_vPos), p1 = reference.GetBall(ball).m_vPos;
  bool passes = false;
  for (std::size_t i = 0; i < m_cScene.m_stdShapes.size(); ++i) {
    if (GetBase(m_cScene.m_stdShapes[i].m_cDesc).m_bIsSensor) continue;
    const CShapeGeometry<double> figure = reference.GetGeometry(i);
    if (std::min(Distance(figure, p0), Distance(figure, p1)) <= r * (1.0 + g_fTouching)) return false;
    passes = passes || Passes(figure, p0, p1, r * (1.0 + g_fPass), r * g_fPiece);
  }
  for (std::size_t i = 0; i < game.GetBalls().size(); ++i) {
    if (i == ball || m_cScene.m_stdBalls[i].m_cDesc.m_bIsSensor) continue;
    const CVec2d x0 = p0 - ToDouble(game.GetBalls()[i].m_vPos), x1 = p1 - reference.GetBall(i).m_vPos;
    const double both = r + reference.GetBall(i).m_fRadius;
    if (std::min(Norm(x0), Norm(x1)) <= both + r * g_fTouching) return false;
    passes = passes || LeastDistance(x0, x1) <= both + r * g_fPass;
  }
  return passes;
}

// As often as there are contacts, and all quiet steps alike: had the next one after each contact been taken,
// all balls would be leaving. The share is what was seen so far.
bool CGhostHunter::IsDrawn(std::size_t contacts) {
  // SplitMix64 of the number of the step.
  std::uint64_t z = m_nSeen += 1;
  z *= 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  const double unit = static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  return unit * static_cast<double>(m_nSeen) < static_cast<double>(contacts);
}

void CGhostHunter::Judge(const CExactGame& game, CImpactTrialResult& result) {
  // An impact of one ball that an engine misses may bring that ball to another one, which is no ghost.
  if (!game.GetEvents().empty()) return;
  const std::size_t contacts = result.m_stdContacts.size();
  m_stdQuiet.clear();
  for (std::size_t i = 0; i < game.GetBalls().size(); ++i)
    if (IsQuiet(game, i) && IsDrawn(contacts) && result.m_nQuietSteps + m_stdQuiet.size() < contacts)
      m_stdQuiet.push_back(i);
  if (m_stdQuiet.empty()) return;
  Ask(game);
  if (!m_stdResponses.empty()) {
    CExactGame ahead = game;
    try {
      for (int i = 0; i < g_nLookAhead && ahead.IsInBounds(); ++i) {
        ahead.Step();
        MarkTouched(ahead);
      }
    } catch (const std::exception&) {
      return; // without the reference the next touches are unknown
    }
  }
  CountGhosts(result);
  result.m_nQuietSteps += m_stdQuiet.size();
}

// Every response of a quiet ball, on every engine.
void CGhostHunter::Ask(const CExactGame& game) {
  m_stdResponses.clear();
  for (std::size_t e = 0; e < m_stdEngines.size(); ++e) {
    CTrialWorld world(m_cScene, m_stdEngines[e], game.GetBalls(), game.GetTime());
    world.m_pWorld->Step();
    for (const CContactEvent& event : world.m_pWorld->GetContacts())
      for (const std::size_t ball : m_stdQuiet) {
        const auto response = AsSeenBy(event, world.m_stdBalls[ball]);
        if (!response) continue;
        const auto& shapes = world.m_stdShapes;
        const auto it = std::lower_bound(shapes.begin(), shapes.end(), response->m_cShape);
        const bool isBall = it == shapes.end();
        const auto& balls = world.m_stdBalls;
        const auto other =
            isBall ? std::lower_bound(balls.begin(), balls.end(), response->m_cShape) - balls.begin()
                   : it - shapes.begin();
        m_stdResponses.push_back({e, ball, static_cast<std::size_t>(other), isBall});
      }
  }
}

// Removes the responses to shapes that the exact ball touched in the last step of the game.
void CGhostHunter::MarkTouched(const CExactGame& game) {
  const CReference<double>& reference = game.GetReference();
  std::erase_if(m_stdResponses, [&](const CResponse& a) {
    const bool met =
        std::any_of(game.GetEvents().begin(), game.GetEvents().end(), [&](const CExactEvent<double>& e) {
          if (e.m_bIsBall != a.m_bIsBall) return false;
          return (e.m_nBall == a.m_nBall && e.m_nShape == a.m_nOther) ||
                 (e.m_bIsBall && e.m_nBall == a.m_nOther && e.m_nShape == a.m_nBall);
        });
    if (met) return true;
    const auto& ball = reference.GetBall(a.m_nBall);
    const double slack = ball.m_fRadius * g_fTouching;
    if (!a.m_bIsBall)
      return Distance(reference.GetGeometry(a.m_nOther), ball.m_vPos) <= ball.m_fRadius + slack;
    const auto& other = reference.GetBall(a.m_nOther);
    return Norm(CVec2d(ball.m_vPos - other.m_vPos)) <= ball.m_fRadius + other.m_fRadius + slack;
  });
}

// One for each ball and engine, for responses to any number of shapes.
void CGhostHunter::CountGhosts(CImpactTrialResult& result) {
  const auto same = [](const CResponse& a, const CResponse& b) {
    return a.m_nEngine == b.m_nEngine && a.m_nBall == b.m_nBall;
  };
  for (auto it = m_stdResponses.begin(); it != m_stdResponses.end(); ++it)
    if (std::none_of(m_stdResponses.begin(), it, [&](const CResponse& a) { return same(a, *it); }))
      ++result.m_stdGhosts[it->m_nEngine];
}

} // namespace Shapes::Compare
