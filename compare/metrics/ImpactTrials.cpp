// SPDX-License-Identifier: MIT
#include "ImpactTrials.h"

#include "Ghosts.h"
#include "ImpactEvaluator.h"

#include <algorithm>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

// Which impacts of a step are judged: the first of each ball, unless it cannot be held against an engine.
class CSelector {
public:
  CSelector(const CScene& scene, CExcluded& aside)
      : m_cScene(scene), m_fSlow(GetSlowSpeed(scene)), m_cAside(aside) {}

  const std::vector<CExactEvent<double>>& Select(const CExactGame& game) {
    m_stdSelected.clear();
    m_stdBusy.clear();
    for (const CExactEvent<double>& event : game.GetEvents()) {
      if (event.m_bIsSensor) continue;
      // Both are marked whichever of them was busy: an impact on a ball that has hit something before is the
      // first of the other one, too.
      const bool first = !IsBusy(event.m_nBall) && !(event.m_bIsBall && IsBusy(event.m_nShape));
      m_stdBusy.push_back(event.m_nBall);
      if (event.m_bIsBall) m_stdBusy.push_back(event.m_nShape);
      if (!first) continue;
      if (std::size_t* pAside = FindReason(game, event))
        ++*pAside;
      else
        m_stdSelected.push_back(event);
    }
    return m_stdSelected;
  }

private:
  bool IsBusy(std::size_t ball) const {
    return std::find(m_stdBusy.begin(), m_stdBusy.end(), ball) != m_stdBusy.end();
  }

  // Why an impact is set aside: the counter of the reason, or nullptr.
  std::size_t* FindReason(const CExactGame& game, const CExactEvent<double>& event) {
    if (event.m_bGraze || event.m_bOverlapped) return &m_cAside.m_nAmbiguous;
    if (event.m_bSimultaneous) return &m_cAside.m_nSimultaneous;
    const double approach = -(event.m_vVelBefore - event.m_vSurface).dot(event.m_vNorm);
    if (approach > m_fSlow) return nullptr;
    const double speed = Norm(event.m_vVelAfter),
                 bounce = static_cast<double>(GetElasticity(m_cScene, game, event)) * approach;
    return speed <= m_fSlow || bounce > g_fRestingTurn * speed ? &m_cAside.m_nResting : nullptr;
  }

  const CScene& m_cScene;
  double m_fSlow;
  CExcluded& m_cAside;
  std::vector<CExactEvent<double>> m_stdSelected;
  std::vector<std::size_t> m_stdBusy;
};

class CRun {
public:
  CRun(const CScene& scene, const std::vector<CEngine>& engines, const CImpactTrialOptions& options)
      : m_cScene(scene),
        m_cOptions(options),
        m_cJudge(scene, engines, options.m_bAsk),
        m_cGhosts(scene, engines),
        m_nSteps(GetStepsPerTrial(scene)),
        m_cSelector(scene, m_cResult.m_cExcluded) {
    m_cResult.m_stdGhosts.assign(engines.size(), 0);
  }

  CImpactTrialResult Play() {
    while (!HasEnough() && m_cResult.m_nTrials < m_cOptions.m_nMostTrials) {
      PlayTrial();
      ++m_cResult.m_nTrials;
      if (m_cOptions.m_stdProgress) m_cOptions.m_stdProgress(GetShare());
    }
    // The last step may have had an impact more than were asked for.
    if (m_cResult.m_stdContacts.size() > m_cOptions.m_nContacts)
      m_cResult.m_stdContacts.resize(m_cOptions.m_nContacts);
    return std::move(m_cResult);
  }

private:
  bool HasEnough() const { return m_cResult.m_stdContacts.size() >= m_cOptions.m_nContacts; }
  double GetShare() const {
    return std::min(1.0, static_cast<double>(m_cResult.m_stdContacts.size()) /
                             static_cast<double>(m_cOptions.m_nContacts));
  }

  void PlayTrial() {
    CExactGame game(m_cScene, MakeStart(m_cScene, m_cOptions.m_nSeed, m_cResult.m_nTrials));
    std::size_t step = 0;
    try {
      for (; step < m_nSteps && !HasEnough() && game.IsInBounds(); ++step) {
        game.Step();
        JudgeStep(game);
      }
    } catch (const std::runtime_error& e) {
      SetAside(step, e.what());
    } catch (const std::invalid_argument& e) { // a state that the reference or an engine cannot hold
      SetAside(step, e.what());
    }
  }

  void JudgeStep(const CExactGame& game) {
    if (const auto& events = m_cSelector.Select(game); !events.empty())
      m_cJudge.Judge(m_cResult.m_nTrials, game, events, m_cResult.m_stdContacts);
    if (m_cOptions.m_bGhosts) m_cGhosts.Judge(game, m_cResult);
  }

  void SetAside(std::size_t step, const std::string& what) {
    CExcluded& aside = m_cResult.m_cExcluded;
    ++aside.m_nUndecided;
    if (!aside.m_sUndecided.empty()) return;
    aside.m_sUndecided =
        "trial " + std::to_string(m_cResult.m_nTrials) + ", step " + std::to_string(step) + ": " + what;
  }

  const CScene& m_cScene;
  const CImpactTrialOptions& m_cOptions;
  CImpactTrialResult m_cResult;
  CImpactEvaluator m_cJudge;
  CGhostHunter m_cGhosts;
  std::size_t m_nSteps;
  CSelector m_cSelector;
};

} // namespace

const char* GetName(ePair pair) {
  switch (pair) {
  case ePair::Point: return "point";
  case ePair::Segment: return "segment";
  case ePair::SegmentEnd: return "segment end";
  case ePair::Circle: return "circle";
  case ePair::Arc: return "arc";
  case ePair::ArcEnd: return "arc end";
  case ePair::Ball: break;
  }
  return "ball";
}

const char* GetName(eOutcome outcome) {
  switch (outcome) {
  case eOutcome::Correct: return "correct";
  case eOutcome::Late: return "late";
  case eOutcome::WrongSide: return "wrong side";
  case eOutcome::Missed: break;
  }
  return "missed";
}

double GetSlowSpeed(const CScene& scene) {
  return g_fSlow * static_cast<double>(scene.m_cWorld.m_vGravity.norm()) *
         static_cast<double>(scene.m_cWorld.m_fTimeStep);
}

CImpactTrialResult RunImpactTrials(const CScene& scene, const std::vector<CEngine>& engines,
                                   const CImpactTrialOptions& options) {
  return CRun(scene, engines, options).Play();
}

} // namespace Shapes::Compare
