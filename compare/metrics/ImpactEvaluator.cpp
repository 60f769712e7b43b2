// SPDX-License-Identifier: MIT
#include "ImpactEvaluator.h"

#include "EngineResponse.h"
#include "PairQuestion.h"
#include "reference/Distance.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <exception>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

using CEvent = CExactEvent<double>;

// Steps after the one of the impact in which a response still counts as late rather than missing.
constexpr int g_nLateSteps = 2;

// An approach below this share of that before the impact is none: floats, and the gravity of a step.
constexpr double g_fStill = 1e-3;

// Points of impact nearer than this to each other are one place, in radii of the ball. A ball that lies on a
// floor touches it at least a radius away from where it meets a wall.
constexpr double g_fSamePlace = 0.5;

ePair GetPair(const CScene& scene, const CEvent& event) {
  if (event.m_bIsBall) return ePair::Ball;
  const bool end = event.m_ePart == ePart::End0 || event.m_ePart == ePart::End1;
  switch (GetBase(scene.m_stdShapes[event.m_nShape].m_cDesc).m_eShapeType) {
  case eShape::Point: return ePair::Point;
  case eShape::LineSeg: return end ? ePair::SegmentEnd : ePair::Segment;
  case eShape::Circle: return ePair::Circle;
  case eShape::Arc: return end ? ePair::ArcEnd : ePair::Arc;
  }
  throw std::logic_error("a shape has no type that a ball can hit");
}

// Well defined for every length; nowhere near a branch where small angles lose their digits.
double AngleBetween(const CVec2d& a, const CVec2d& b) { return std::atan2(std::abs(Cross(a, b)), a.dot(b)); }

std::ptrdiff_t CountImpacts(const std::vector<CEvent>& events, std::size_t ball) {
  return std::count_if(events.begin(), events.end(), [&](const CEvent& e) {
    return !e.m_bIsSensor && (e.m_nBall == ball || (e.m_bIsBall && e.m_nShape == ball));
  });
}

// Whether nothing else than this event has bent the ways of those who take part in it: `impacts` of each in
// these events.
bool IsAlone(const CEvent& event, const std::vector<CEvent>& all, std::ptrdiff_t impacts) {
  return CountImpacts(all, event.m_nBall) == impacts &&
         (!event.m_bIsBall || CountImpacts(all, event.m_nShape) == impacts);
}

struct CAnswer {
  CResponse m_cResponse;
  eOutcome m_eOutcome;
};

// One event and the world of one engine at the end of its step.
class CEndOfStep {
public:
  CEndOfStep(const CExactGame& game, const CTrialWorld& world, const CEvent& event)
      : m_cGame(game),
        m_cWorld(world),
        m_cEvent(event),
        m_fRadius(game.GetReference().GetBall(event.m_nBall).m_fRadius) {}

  // The response as it is reported.
  void Touch(const CResponse& response, CEngineContact& c) const {
    c.m_fPOIError = static_cast<float>(Norm(CVec2d(ToDouble(response.m_vPOI) - m_cEvent.m_vPOI)) / m_fRadius);
    c.m_fNormalError = static_cast<float>(AngleBetween(ToDouble(response.m_vNorm), m_cEvent.m_vNorm));
  }

  // The state, against that of the exact game.
  void Compare(CEngineContact& c) const {
    const auto& exact = m_cGame.GetReference().GetBall(m_cEvent.m_nBall);
    const CVec2d v = GetVel(m_cEvent.m_nBall);
    const double speed = Norm(exact.m_vVel);
    if (!(speed > 0.0)) return;
    double energy = GetEnergy(m_cEvent.m_nBall), exactEnergy = GetExactEnergy(m_cEvent.m_nBall);
    if (m_cEvent.m_bIsBall) {
      energy += GetEnergy(m_cEvent.m_nShape);
      exactEnergy += GetExactEnergy(m_cEvent.m_nShape);
    }
    c.m_fDirectionError =
        static_cast<float>(v.isZero(0.0) ? std::numbers::pi : AngleBetween(v, exact.m_vVel));
    c.m_fSpeedError = static_cast<float>(Norm(v) / speed - 1.0);
    c.m_fEnergyError = static_cast<float>(energy / exactEnergy - 1.0);
    c.m_fPositionError =
        static_cast<float>(Norm(CVec2d(GetPos(m_cEvent.m_nBall) - exact.m_vPos)) / m_fRadius);
    c.m_bCompared = std::isfinite(c.m_fDirectionError) && std::isfinite(c.m_fSpeedError) &&
                    std::isfinite(c.m_fEnergyError) && std::isfinite(c.m_fPositionError);
  }

  // The response to what the exact ball met, or else another one that does as well.
  std::optional<CAnswer> FindAnswer(CShapeId other, int late) const {
    std::optional<CAnswer> answer;
    for (const CContactEvent& contact : m_cWorld.m_pWorld->GetContacts()) {
      const auto response = AsSeenBy(contact, m_cWorld.m_stdBalls[m_cEvent.m_nBall]);
      if (!response) continue;
      const bool same = response->m_cShape == other;
      const auto outcome = GetOutcome(*response, same, late);
      if (outcome && (same || !answer)) answer = CAnswer{*response, *outcome};
      if (outcome && same) break;
    }
    return answer;
  }

  // The outcome of a response, if it belongs to this event. A response to another shape (a guard point, the
  // neighbour at a shared end) does only in the step of the impact, and only if it was in the same place, or
  // if the ball no longer approaches the exactly hit shape.
  std::optional<eOutcome> GetOutcome(const CResponse& response, bool sameShape, int late) const {
    const bool back = ToDouble(response.m_vNorm).dot(m_cEvent.m_vNorm) >= 0.0 && IsOnExactSide();
    if (!sameShape && (late > 0 || !back || (!IsSamePlace(response) && Approaches()))) return std::nullopt;
    if (!back) return eOutcome::WrongSide;
    return late == 0 ? eOutcome::Correct : eOutcome::Late;
  }

  // Whether the ball rests or slides: of what it would have after a bounce it may lack the bounce itself, but
  // not that and half of the approach.
  bool HasComeToRest(double approach, double elasticity) const {
    const auto& exact = m_cGame.GetReference();
    CVec2d v = GetVel(m_cEvent.m_nBall) - exact.GetBall(m_cEvent.m_nBall).m_vVel;
    if (m_cEvent.m_bIsBall) v -= GetVel(m_cEvent.m_nShape) - exact.GetBall(m_cEvent.m_nShape).m_vVel;
    return v.dot(m_cEvent.m_vNorm) > -(elasticity + 0.5) * approach && IsOnExactSide();
  }

  float GetPenetration() const {
    const CVec2d p = GetPos(m_cEvent.m_nBall);
    const auto& reference = m_cGame.GetReference();
    const double reach =
        m_cEvent.m_bIsBall ? m_fRadius + reference.GetBall(m_cEvent.m_nShape).m_fRadius : m_fRadius;
    const double distance = m_cEvent.m_bIsBall ? Norm(CVec2d(p - GetPos(m_cEvent.m_nShape)))
                                               : Distance(reference.GetGeometry(m_cEvent.m_nShape), p);
    return static_cast<float>(std::max(0.0, reach - distance) / m_fRadius);
  }

private:
  bool IsSamePlace(const CResponse& response) const {
    return Norm(CVec2d(ToDouble(response.m_vPOI) - m_cEvent.m_vPOI)) <= g_fSamePlace * m_fRadius;
  }

  bool Approaches() const {
    const CVec2d v =
        GetVel(m_cEvent.m_nBall) - (m_cEvent.m_bIsBall ? GetVel(m_cEvent.m_nShape) : m_cEvent.m_vSurface);
    return v.dot(m_cEvent.m_vNorm) < -g_fStill * Norm(CVec2d(m_cEvent.m_vVelBefore - m_cEvent.m_vSurface));
  }

  // Whether the centre is on the side of the shape that the exact ball met. Ends, points and balls have none.
  bool IsOnExactSide() const {
    if (m_cEvent.m_bIsBall) return true;
    const CShapeGeometry<double> f = m_cGame.GetReference().GetGeometry(m_cEvent.m_nShape);
    const CVec2d p = GetPos(m_cEvent.m_nBall);
    const double above = Cross(CVec2d(f.m_vPt1 - f.m_vPt0), CVec2d(p - f.m_vPt0)),
                 out = Norm(CVec2d(p - f.m_vCenter)) - f.m_fRadius;
    switch (m_cEvent.m_ePart) {
    case ePart::Front: return above >= 0.0;
    case ePart::Back: return above <= 0.0;
    case ePart::Outside: return out >= 0.0;
    case ePart::Inside: return out <= 0.0;
    default: return true;
    }
  }

  CVec2d GetPos(std::size_t ball) const {
    return ToDouble(m_cWorld.m_pWorld->GetPos(m_cWorld.m_stdBalls[ball]));
  }
  CVec2d GetVel(std::size_t ball) const {
    return ToDouble(m_cWorld.m_pWorld->GetVel(m_cWorld.m_stdBalls[ball]));
  }
  // Twice the kinetic energy.
  double GetEnergy(std::size_t ball) const {
    return m_cGame.GetReference().GetBall(ball).m_fMass * GetVel(ball).squaredNorm();
  }
  double GetExactEnergy(std::size_t ball) const {
    const auto& exact = m_cGame.GetReference().GetBall(ball);
    return exact.m_fMass * exact.m_vVel.squaredNorm();
  }

  const CExactGame& m_cGame;
  const CTrialWorld& m_cWorld;
  const CEvent& m_cEvent;
  double m_fRadius;
};

} // namespace

float GetElasticity(const CScene& scene, const CExactGame& game, const CEvent& event) {
  const CDynamicCircleDesc& ball = game.GetBalls()[event.m_nBall];
  return ball.m_fElasticity * (event.m_bIsBall
                                   ? game.GetBalls()[event.m_nShape].m_fElasticity
                                   : GetBase(scene.m_stdShapes[event.m_nShape].m_cDesc).m_fElasticity);
}

// The exact game at the end of the step of the impacts and of those after it, which are played when they are
// asked for.
class CAhead {
public:
  explicit CAhead(const CExactGame& game) : m_cGame(game) {}

  /// After `late` further steps; the last that the reference could decide if it gave up before.
  const CExactGame& Find(int late) {
    while (static_cast<int>(m_stdLater.size()) < late && !m_bEnds)
      Play();
    return late == 0 || m_stdLater.empty()
               ? m_cGame
               : m_stdLater[std::min<std::size_t>(m_stdLater.size(), static_cast<std::size_t>(late)) - 1];
  }

  /// Whether it could decide these steps, and nothing but the event happened in them to those who take part.
  bool IsClear(int late, const CEvent& event) {
    Find(late);
    if (static_cast<int>(m_stdLater.size()) < late || !IsAlone(event, m_cGame.GetEvents(), 1)) return false;
    return std::all_of(m_stdLater.begin(), m_stdLater.begin() + late,
                       [&](const CExactGame& game) { return IsAlone(event, game.GetEvents(), 0); });
  }

private:
  void Play() {
    CExactGame next = m_stdLater.empty() ? m_cGame : m_stdLater.back();
    try {
      next.Step();
      m_stdLater.push_back(std::move(next));
    } catch (const std::exception&) {
      m_bEnds = true;
    }
  }

  const CExactGame& m_cGame;
  std::deque<CExactGame> m_stdLater; // where they are does not change
  bool m_bEnds = false;
};

void CImpactEvaluator::Judge(std::uint64_t trial, const CExactGame& game, std::span<const CEvent> events,
                             std::vector<CContact>& contacts) const {
  const std::size_t first = contacts.size();
  for (const CEvent& event : events)
    contacts.push_back(Describe(trial, game, event));
  const std::span<CContact> judged = std::span(contacts).subspan(first);
  try {
    CAhead ahead(game);
    for (std::size_t e = 0; e < m_stdEngines.size(); ++e)
      Run(e, game, events, ahead, judged);
    for (std::size_t i = 0; m_bAsk && i < events.size(); ++i)
      Ask(game, events[i], judged[i]);
  } catch (...) {
    contacts.resize(first); // half a judgement would read as misses
    throw;
  }
}

CContact CImpactEvaluator::Describe(std::uint64_t trial, const CExactGame& game, const CEvent& event) const {
  const CVec2d v = event.m_vVelBefore - event.m_vSurface;
  const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep), approach = -v.dot(event.m_vNorm);
  const CDynamicCircleDesc& ball = game.GetBalls()[event.m_nBall];
  CContact c;
  c.m_nTrial = trial;
  c.m_nStep = static_cast<std::uint32_t>(game.GetSteps() - 1);
  c.m_nBall = static_cast<std::uint32_t>(event.m_nBall);
  c.m_ePair = GetPair(m_cScene, event);
  c.m_fTime = static_cast<float>(event.m_fTime / dt);
  c.m_fTravel = static_cast<float>(Norm(event.m_vVelBefore) * dt / static_cast<double>(ball.m_fRadius));
  c.m_fApproach = static_cast<float>(approach);
  c.m_fIncidence = static_cast<float>(AngleBetween(-v, event.m_vNorm));
  c.m_fElasticity = GetElasticity(m_cScene, game, event);
  c.m_stdEngines.resize(m_stdEngines.size());
  return c;
}

// All events share one world: they belong to different balls.
void CImpactEvaluator::Run(std::size_t engine, const CExactGame& game, std::span<const CEvent> events,
                           CAhead& ahead, std::span<CContact> contacts) const {
  CTrialWorld world(m_cScene, m_stdEngines[engine], game.GetBalls(), game.GetTime());
  const double slow = GetSlowSpeed(m_cScene);
  std::size_t open = events.size();
  for (int late = 0; late <= g_nLateSteps && open > 0; ++late) {
    if (late > 0)
      world.Flip(m_cScene, game.GetTime() + late * static_cast<double>(m_cScene.m_cWorld.m_fTimeStep));
    world.m_pWorld->Step();
    for (std::size_t i = 0; i < events.size(); ++i) {
      const CEvent& event = events[i];
      CEngineContact& c = contacts[i].m_stdEngines[engine];
      if (late == 0) c.m_fPenetration = CEndOfStep(game, world, event).GetPenetration();
      if (c.m_eOutcome != eOutcome::Missed) continue;
      const CShapeId other = (event.m_bIsBall ? world.m_stdBalls : world.m_stdShapes)[event.m_nShape];
      const CEndOfStep end(ahead.Find(late), world, event);
      const auto answer = end.FindAnswer(other, late);
      const double approach = static_cast<double>(contacts[i].m_fApproach);
      c.m_bReported = answer.has_value();
      if (answer)
        c.m_eOutcome = answer->m_eOutcome;
      else if (approach <= slow &&
               end.HasComeToRest(approach, static_cast<double>(contacts[i].m_fElasticity)))
        c.m_eOutcome = late == 0 ? eOutcome::Correct : eOutcome::Late;
      else
        continue;
      --open;
      if (!c.HasTurnedBack()) continue;
      if (answer) end.Touch(answer->m_cResponse, c);
      if (ahead.IsClear(late, event)) end.Compare(c);
    }
  }
}

void CImpactEvaluator::Ask(const CExactGame& game, const CEvent& event, CContact& contact) const {
  const CDynamicCircleDesc& ball = game.GetBalls()[event.m_nBall];
  const CPairQuestion question =
      event.m_bIsBall
          ? CPairQuestion(game.GetBalls()[event.m_nShape], ball, m_cScene.m_cWorld)
          : CPairQuestion(m_cScene.m_stdShapes[event.m_nShape], ball, game.GetTime(), m_cScene.m_cWorld);
  const double r = static_cast<double>(ball.m_fRadius);
  const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep);
  const CVec2d v = event.m_vVelBefore - event.m_vSurface;
  std::vector<CVec2d> centres;
  CPairQuestion::CAnswer answer;
  for (std::size_t i = 0; i < m_stdEngines.size(); ++i) {
    const CBackend* pBackend = m_stdEngines[i].m_pBackend; // settings of one engine have one answer
    if (i == 0 || pBackend != m_stdEngines[i - 1].m_pBackend) answer = question.Ask(*pBackend);
    centres.push_back(answer.m_vCentre);
    CEngineContact& c = contact.m_stdEngines[i];
    const CVec2d error = answer.m_vCentre - event.m_vCenter;
    c.m_bDetected = answer.m_bDetected && error.allFinite();
    if (!c.m_bDetected) continue;
    c.m_fSetback = static_cast<float>(static_cast<double>(answer.m_fSetback) / r);
    c.m_fSetbackError = static_cast<float>(Norm(error) / r);
    c.m_fSetbackErrorNormal = static_cast<float>(error.dot(event.m_vNorm) / r);
    c.m_fTimeError = static_cast<float>(error.dot(v) / (v.squaredNorm() * dt));
  }
  const auto other = FindOther(m_stdEngines);
  contact.m_bHasDifference =
      other && contact.m_stdEngines[0].m_bDetected && contact.m_stdEngines[*other].m_bDetected;
  if (contact.m_bHasDifference)
    contact.m_fDifference = static_cast<float>(Norm(CVec2d(centres[0] - centres[*other])) / r);
}

} // namespace Shapes::Compare
