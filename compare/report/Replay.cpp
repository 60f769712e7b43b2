// SPDX-License-Identifier: MIT
#include "Replay.h"

#include "scene/ExactGame.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace Shapes::Compare {
namespace {

// Of the clip of a worst contact: most steps before it, and steps from it on.
constexpr std::size_t g_nBefore = 20, g_nAfter = 30;

// How bad a contact is on an engine: tunneling first, then the largest error of the direction, then of the
// setback.
double Badness(const CEngineContact& c) {
  if (c.m_eOutcome == eOutcome::Missed || c.m_eOutcome == eOutcome::WrongSide) return 1e6;
  if (c.m_bCompared) return 1e3 + static_cast<double>(c.m_fDirectionError);
  return c.m_bDetected ? static_cast<double>(c.m_fSetbackError) : 0.0;
}

std::string Happened(eOutcome outcome, const char* pWhat) {
  switch (outcome) {
  case eOutcome::Correct: return fmt::format("meets the {}", pWhat);
  case eOutcome::Late: return fmt::format("meets the {} late", pWhat);
  case eOutcome::WrongSide: return fmt::format("pushes the ball through the {}", pWhat);
  case eOutcome::Missed: break;
  }
  return fmt::format("misses the {}", pWhat);
}

std::string Describe(const CContact& contact, const CEngine& engine, const CEngineContact& c) {
  std::string text = fmt::format("{} {}", engine.m_sName, Happened(c.m_eOutcome, GetName(contact.m_ePair)));
  if (c.m_bCompared) text += fmt::format(", direction {:.3g} rad off", c.m_fDirectionError);
  if (c.m_bDetected) text += fmt::format(", put {:.2g} radii from the exact place", c.m_fSetbackError);
  return text +
         fmt::format(" (trial {}, step {}, ball {})", contact.m_nTrial, contact.m_nStep, contact.m_nBall);
}

class CClipMaker {
public:
  CClipMaker(const CScene& scene, const std::vector<CEngine>& engines, std::uint64_t seed)
      : m_cScene(scene), m_stdEngines(engines), m_nSeed(seed) {}

  // From step `first` of a trial on, `frames` steps.
  void Record(std::uint64_t trial, std::size_t first, std::size_t frames, CClip& clip) const {
    const CStart start = MakeStart(m_cScene, m_nSeed, trial);
    CExactGame exact(m_cScene, start);
    for (std::size_t i = 0; i <= first; ++i)
      exact.Step();
    clip.m_fTime = exact.GetTime();
    const std::vector<CDynamicCircleDesc> balls = exact.GetBalls();
    std::vector<Vector2> at;
    for (const CDynamicCircleDesc& ball : balls)
      at.push_back(ball.m_vPos);
    clip.m_stdTracks.assign(m_stdEngines.size() + 1, at);
    for (std::size_t e = 0; e < m_stdEngines.size(); ++e) {
      CGame game(m_cScene, m_stdEngines[e], start, balls, clip.m_fTime);
      game.SetPutBack(false); // a ball that tunneled is to be seen on the other side
      for (std::size_t i = 0; i < frames; ++i) {
        game.Step();
        for (const Vector2& p : game.GetWorld().GetBallPositions())
          clip.m_stdTracks[e].push_back(p);
      }
    }
    for (std::size_t i = 0; i < frames; ++i) {
      if (i > 0 && !(exact.TryStep() && exact.IsInBounds())) break;
      for (std::size_t b = 0; b < balls.size(); ++b)
        clip.m_stdTracks.back().push_back(exact.GetReference().GetBall(b).m_vPos.cast<float>());
    }
    Cut(clip, balls.size());
  }

  // The step after the last impact of the ball before step `contact`, at most g_nBefore before it.
  std::size_t FindStart(std::uint64_t trial, std::size_t contact, std::size_t ball) const {
    CExactGame exact(m_cScene, MakeStart(m_cScene, m_nSeed, trial));
    std::size_t first = contact > g_nBefore ? contact - g_nBefore : 0;
    for (std::size_t i = 0; i < contact; ++i) {
      exact.Step();
      for (const CExactEvent<double>& event : exact.GetEvents())
        if (event.m_nBall == ball || (event.m_bIsBall && event.m_nShape == ball))
          first = std::max(first, i + 1);
    }
    return first;
  }

private:
  // All tracks as long as the shortest.
  static void Cut(CClip& clip, std::size_t balls) {
    std::size_t shortest = clip.m_stdTracks.front().size();
    for (const auto& track : clip.m_stdTracks)
      shortest = std::min(shortest, track.size() / balls * balls);
    for (auto& track : clip.m_stdTracks)
      track.resize(shortest);
  }

  const CScene& m_cScene;
  const std::vector<CEngine>& m_stdEngines;
  std::uint64_t m_nSeed;
};

} // namespace

std::vector<CClip> MakeClips(const CScene& scene, const std::vector<CEngine>& engines,
                             const CImpactTrialResult& restarts, std::uint64_t seed, std::size_t frames) {
  const CClipMaker maker(scene, engines, seed);
  std::vector<CClip> clips;
  const auto steps = static_cast<std::size_t>(scene.m_fDuration / scene.m_cWorld.m_fTimeStep) + 1;
  try {
    CClip clip;
    clip.m_sName = "start";
    maker.Record(0, 0, std::min(frames, steps), clip);
    clips.push_back(std::move(clip));
  } catch (const std::runtime_error&) {
    // The reference gives up at once: there is nothing to compare with.
  }
  for (std::size_t e = 0; e < engines.size(); ++e) {
    const auto& contacts = restarts.m_stdContacts;
    const auto worst =
        std::max_element(contacts.begin(), contacts.end(), [&](const CContact& a, const CContact& b) {
          return Badness(a.m_stdEngines[e]) < Badness(b.m_stdEngines[e]);
        });
    if (worst == contacts.end()) continue;
    CClip clip;
    clip.m_sName = "worst " + engines[e].m_sName;
    clip.m_sWhat = Describe(*worst, engines[e], worst->m_stdEngines[e]);
    clip.m_nBall = worst->m_nBall;
    const std::size_t first = maker.FindStart(worst->m_nTrial, worst->m_nStep, worst->m_nBall);
    clip.m_nContact = worst->m_nStep - first + 1;
    // Where contact lasts, a pile follows on the time of the trial, for which the reference takes long.
    const std::size_t end = clip.m_nContact + g_nAfter, most = scene.m_fLasting > 0.0f ? steps - first : end;
    maker.Record(worst->m_nTrial, first, std::max<std::size_t>(clip.m_nContact, std::min(end, most)), clip);
    clips.push_back(std::move(clip));
  }
  return clips;
}

} // namespace Shapes::Compare
