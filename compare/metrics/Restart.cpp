// SPDX-License-Identifier: MIT
#include "Restart.h"

#include "../reference/Reference.h"
#include "PairQuestion.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace Shapes::Compare {
namespace {

// Steps after the one of the impact in which a response still counts as late rather than missing.
constexpr int g_nLateSteps = 2;

Vector2 ToFloat(const CVec2d& v) { return v.cast<float>(); }

// The state of a scene at the beginning of a step, as every engine gets it.
struct CMoment {
  std::uint64_t m_nTrial;
  std::size_t m_nStep;
  double m_fTime;
  std::vector<CDynamicCircleDesc> m_stdBalls;
};

const char* PairName(const CScene& scene, const CExactEvent& event) {
  if (event.m_bIsBall) return "ball";
  switch (scene.m_stdShapes[event.m_nShape].m_cDesc.index()) {
  case 0: return "point";
  case 1: return event.m_ePart == ePart::End0 || event.m_ePart == ePart::End1 ? "segment end" : "segment";
  case 2: return "circle";
  default: return event.m_ePart == ePart::End0 || event.m_ePart == ePart::End1 ? "arc end" : "arc";
  }
}

// Whether an event was a response: it changed the velocity or the position. Box2D also reports balls that
// leave.
bool IsResponse(const CContactEvent& event) {
  return !event.m_bIsSensor && (event.m_fSpeed > 0.0f || event.m_fSetback > 0.0f);
}

// The first response of a ball in the last step of an engine, to `shape` if there is one; from the ball's
// side, so of two balls the normal may have to be turned around.
std::optional<Vector2> FindResponse(const CWorld& world, CShapeId ball, CShapeId shape, bool onlyShape) {
  std::optional<Vector2> first;
  for (const CContactEvent& event : world.GetContacts()) {
    const bool isBall = event.m_cBall == ball;
    if (!IsResponse(event) || (!isBall && event.m_cShape != ball)) continue;
    const Vector2 n = isBall ? event.m_vNorm : Vector2(-event.m_vNorm);
    if ((isBall ? event.m_cShape : event.m_cBall) == shape) return n;
    if (!onlyShape && !first) first = n;
  }
  return first;
}

// Which of the impacts of a step are judged: the first of each ball, sensors and resting contacts aside.
std::vector<CExactEvent> Select(const std::vector<CExactEvent>& events, double slow, CRestartResult& result) {
  std::vector<CExactEvent> selected;
  std::vector<std::size_t> done;
  for (const CExactEvent& event : events) {
    if (event.m_bIsSensor) continue;
    const auto busy = [&](std::size_t ball) {
      return std::find(done.begin(), done.end(), ball) != done.end();
    };
    if (busy(event.m_nBall) || (event.m_bIsBall && busy(event.m_nShape))) continue;
    done.push_back(event.m_nBall);
    if (event.m_bIsBall) done.push_back(event.m_nShape);
    if (event.m_bGraze || event.m_bOverlapped)
      ++result.m_nAmbiguous;
    else if (-(event.m_vVelBefore - event.m_vSurface).dot(event.m_vNorm) <= slow)
      ++result.m_nResting;
    else
      selected.push_back(event);
  }
  return selected;
}

class CJudge {
public:
  CJudge(const CScene& scene, const std::vector<CEngine>& engines) : m_cScene(scene), m_stdEngines(engines) {}

  void Judge(const CMoment& moment, const std::vector<CExactEvent>& events, CRestartResult& result) const {
    std::vector<CContact> contacts;
    for (const CExactEvent& event : events)
      contacts.push_back(Describe(moment, event));
    for (const CEngine& engine : m_stdEngines)
      Run(engine, moment, events, contacts);
    for (std::size_t i = 0; i < events.size(); ++i)
      Ask(moment, events[i], contacts[i]);
    for (CContact& contact : contacts)
      result.m_stdContacts.push_back(std::move(contact));
  }

private:
  CContact Describe(const CMoment& moment, const CExactEvent& event) const {
    const CVec2d v = event.m_vVelBefore - event.m_vSurface;
    const double speed = v.norm(), approach = -v.dot(event.m_vNorm), dt = m_cScene.m_cWorld.m_fTimeStep;
    CContact c;
    c.m_nTrial = moment.m_nTrial;
    c.m_nStep = moment.m_nStep;
    c.m_nBall = event.m_nBall;
    c.m_sPair = PairName(m_cScene, event);
    c.m_fTime = event.m_fTime / dt;
    c.m_fTravel =
        event.m_vVelBefore.norm() * dt / static_cast<double>(moment.m_stdBalls[event.m_nBall].m_fRadius);
    c.m_fApproach = approach;
    c.m_fIncidence = std::acos(std::clamp(approach / speed, -1.0, 1.0));
    return c;
  }

  // All events of the moment share one world: they belong to different balls.
  void Run(const CEngine& engine, const CMoment& moment, const std::vector<CExactEvent>& events,
           std::vector<CContact>& contacts) const {
    CTrialWorld world(m_cScene, engine, moment.m_stdBalls, moment.m_fTime);
    std::vector<bool> answered(events.size(), false);
    for (CContact& contact : contacts)
      contact.m_stdEngines.emplace_back();
    for (int late = 0; late <= g_nLateSteps; ++late) {
      world.m_pWorld->Step();
      for (std::size_t i = 0; i < events.size(); ++i) {
        if (answered[i]) continue;
        const CExactEvent& event = events[i];
        const auto& others = event.m_bIsBall ? world.m_stdBalls : world.m_stdShapes;
        const auto n =
            FindResponse(*world.m_pWorld, world.m_stdBalls[event.m_nBall], others[event.m_nShape], late > 0);
        if (!n) continue;
        answered[i] = true;
        const bool right = n->cast<double>().dot(event.m_vNorm) >= 0.0;
        contacts[i].m_stdEngines.back().m_eOutcome = !right      ? eOutcome::WrongSide
                                                     : late == 0 ? eOutcome::Correct
                                                                 : eOutcome::Late;
      }
      if (std::find(answered.begin(), answered.end(), false) == answered.end()) return;
    }
  }

  void Ask(const CMoment& moment, const CExactEvent& event, CContact& contact) const {
    const CDynamicCircleDesc& ball = moment.m_stdBalls[event.m_nBall];
    const CPairQuestion question =
        event.m_bIsBall
            ? CPairQuestion(moment.m_stdBalls[event.m_nShape], ball, m_cScene.m_cWorld)
            : CPairQuestion(m_cScene.m_stdShapes[event.m_nShape], ball, moment.m_fTime, m_cScene.m_cWorld);
    std::vector<CPairQuestion::CAnswer> answers;
    for (std::size_t i = 0; i < m_stdEngines.size(); ++i) {
      const auto answer = question.Ask(*m_stdEngines[i].m_pBackend);
      answers.push_back(answer);
      CEngineContact& c = contact.m_stdEngines[i];
      c.m_bDetected = answer.m_bDetected;
      if (!answer.m_bDetected) continue;
      const double r = ball.m_fRadius;
      c.m_fSetback = static_cast<double>(answer.m_fSetback) / r;
      c.m_fSetbackError = (answer.m_vCentre.cast<double>() - event.m_vCenter).norm() / r;
    }
    if (answers.size() < 2 || !answers[0].m_bDetected || !answers[1].m_bDetected) return;
    contact.m_bHasDifference = true;
    contact.m_fDifference =
        static_cast<double>((answers[0].m_vCentre - answers[1].m_vCentre).norm() / ball.m_fRadius);
  }

  const CScene& m_cScene;
  const std::vector<CEngine>& m_stdEngines;
};

void Total(CRestartResult& result, std::size_t engines) {
  std::vector<double> differences;
  for (const CContact& contact : result.m_stdContacts)
    if (contact.m_bHasDifference) differences.push_back(contact.m_fDifference);
  result.m_cDifference = Summarise(std::move(differences));

  for (std::size_t i = 0; i < engines; ++i) {
    CEngineTotals totals;
    std::vector<double> setbacks, errors;
    for (const CContact& contact : result.m_stdContacts) {
      const CEngineContact& c = contact.m_stdEngines[i];
      totals.m_nMissed += c.m_eOutcome == eOutcome::Missed;
      totals.m_nWrongSide += c.m_eOutcome == eOutcome::WrongSide;
      totals.m_nLate += c.m_eOutcome == eOutcome::Late;
      if (!c.m_bDetected) continue;
      setbacks.push_back(c.m_fSetback);
      errors.push_back(c.m_fSetbackError);
    }
    totals.m_cSetback = Summarise(std::move(setbacks));
    totals.m_cSetbackError = Summarise(std::move(errors));
    result.m_stdEngines.push_back(totals);
  }
}

// Plays one trial on the reference and judges its impacts, until there are enough.
void PlayTrial(const CScene& scene, const CJudge& judge, const CStart& start, std::size_t contacts,
               CRestartResult& result) {
  std::vector<CAnyShapeDesc> shapes;
  for (const CSceneShape& shape : scene.m_stdShapes)
    shapes.push_back(shape.m_cDesc);
  CReference reference(shapes, start.m_stdBalls, scene.m_cWorld.m_vGravity);

  const double dt = scene.m_cWorld.m_fTimeStep;
  // Gravity alone gives a resting ball this approach speed in every step.
  const double slow = 2.0 * static_cast<double>(scene.m_cWorld.m_vGravity.norm()) * dt;
  const auto steps = static_cast<std::size_t>(std::ceil(static_cast<double>(scene.m_fDuration) / dt));
  CMoment moment{result.m_nTrials, 0, start.m_fTime, start.m_stdBalls};
  std::vector<CExactEvent> events;
  for (; moment.m_nStep < steps && result.m_stdContacts.size() < contacts; ++moment.m_nStep) {
    // What the engines get is float, so the reference starts the step from the same floats.
    for (std::size_t i = 0; i < moment.m_stdBalls.size(); ++i) {
      CDynamicCircleDesc& ball = moment.m_stdBalls[i];
      ball.m_vPos = ToFloat(reference.GetBall(i).m_vPos);
      ball.m_vVel = ToFloat(reference.GetBall(i).m_vVel);
      if (!(scene.m_cBounds && ball.m_vPos)) return; // it has flown away: nothing more to see
      reference.SetBall(i, ball.m_vPos.cast<double>(), ball.m_vVel.cast<double>());
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const float speed = RotSpeedAt(scene.m_stdShapes[i], moment.m_fTime, dt);
      if (speed == 0.0f && reference.GetRotSpeed(i) == 0.0) continue;
      reference.SetOrientation(i, static_cast<double>(OrientationAt(scene.m_stdShapes[i], moment.m_fTime)));
      reference.SetRotSpeed(i, static_cast<double>(speed));
    }
    events.clear();
    reference.Step(dt, events);
    if (const auto selected = Select(events, slow, result); !selected.empty())
      judge.Judge(moment, selected, result);
    for (const CExactEvent& event : events)
      if (!event.m_bIsBall && scene.m_stdShapes[event.m_nShape].m_bIsDrain)
        reference.SetBall(event.m_nBall, start.m_stdBalls[event.m_nBall].m_vPos.cast<double>(),
                          start.m_stdBalls[event.m_nBall].m_vVel.cast<double>());
    moment.m_fTime += dt;
  }
}

} // namespace

CRestartResult RunRestarts(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed,
                           std::size_t contacts, std::uint64_t mostTrials) {
  CRestartResult result;
  const CJudge judge(scene, engines);
  for (; result.m_nTrials < mostTrials && result.m_stdContacts.size() < contacts; ++result.m_nTrials)
    PlayTrial(scene, judge, MakeStart(scene, seed, result.m_nTrials), contacts, result);
  if (result.m_stdContacts.size() > contacts) result.m_stdContacts.resize(contacts);
  Total(result, engines.size());
  return result;
}

} // namespace Shapes::Compare
