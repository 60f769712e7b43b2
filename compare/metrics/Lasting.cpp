// SPDX-License-Identifier: MIT
#include "Lasting.h"

#include "Energy.h"
#include "Stopwatch.h"
#include "reference/Distance.h"
#include "reference/Reference.h"

#include <algorithm>

namespace Shapes::Compare {
namespace {

// Heights are known, and nothing but gravity does work.
bool KeepsOrLosesEnergy(const CScene& scene) {
  return !scene.m_cWorld.m_vGravity.isZero(0.0f) &&
         std::all_of(scene.m_stdBalls.begin(), scene.m_stdBalls.end(),
                     [](const CSceneBall& ball) { return ball.m_cDesc.m_fElasticity <= 1.0f; }) &&
         std::none_of(scene.m_stdShapes.begin(), scene.m_stdShapes.end(), [](const CSceneShape& shape) {
           return Moves(shape) || shape.m_bIsDrain || GetBase(shape.m_cDesc).m_fElasticity > 1.0f;
         });
}

// One trial on one engine, looked at after every step.
class CLastingGame {
public:
  CLastingGame(const CScene& scene, const CEngine& engine, const CStart& start)
      : m_cScene(scene),
        m_cStart(start),
        m_cGame(scene, engine, start),
        m_cShapes(GetShapes(scene), {}, scene.m_cWorld.m_vGravity),
        m_cEnergy(scene),
        m_stdTouched(start.m_stdBalls.size(), false) {
    m_cGame.SetPutBack(false);
  }

  void Play() {
    const std::size_t steps = CountSteps(m_cScene, m_cScene.m_fLasting),
                      end = steps - static_cast<std::size_t>(g_fLastingEnd * static_cast<double>(steps));
    const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep),
                 slow = g_fAtRest * static_cast<double>(m_cScene.m_cWorld.m_vGravity.norm()) * dt;
    double before = GetEnergy();
    m_fStartEnergy = before;
    for (std::size_t i = 0; i < steps; ++i) {
      m_cGame.Step();
      const double after = GetEnergy(), speed = GetSpeed(), time = static_cast<double>(i + 1) * dt;
      m_fGained += std::max(0.0, after - before);
      before = after;
      if (!(speed <= slow)) m_fRestTime = time;
      NoteTouches(time);
      if (i + 1 < end) continue;
      m_fSpeed = std::max(m_fSpeed, speed);
      m_fOverlap = std::max(m_fOverlap, GetOverlap(m_cStart.m_fTime + time));
    }
    m_bRests = m_fRestTime < static_cast<double>(end) * dt;
  }

  std::size_t CountLost() const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_stdTouched.size(); ++i)
      n += IsLost(i);
    return n;
  }
  double GetDeepest() const { return m_fOverlap; }
  double GetFastest() const { return m_fSpeed; }
  double GetEnergyGained() const { return m_fGained / m_fStartEnergy; }
  std::optional<double> GetRestTime() const { return m_bRests ? std::optional(m_fRestTime) : std::nullopt; }
  double GetFlow() const { return m_fLastTouch > 0.0 ? m_nTouched / m_fLastTouch : 0.0; }

private:
  CVec2d GetPos(std::size_t i) const { return ToDouble(m_cGame.GetWorld().GetBallPositions()[i]); }
  CVec2d GetVel(std::size_t i) const { return ToDouble(m_cGame.GetWorld().GetBallVelocities()[i]); }
  const CFilter& GetFilter(std::size_t i) const { return m_cStart.m_stdBalls[i].m_cFilter; }
  double GetRadius(std::size_t i) const { return static_cast<double>(m_cStart.m_stdBalls[i].m_fRadius); }
  bool IsLost(std::size_t i) const {
    return !(m_cScene.m_cBounds && m_cGame.GetWorld().GetBallPositions()[i]);
  }

  double GetEnergy() const {
    double energy = 0.0;
    for (std::size_t i = 0; i < m_stdTouched.size(); ++i)
      if (!IsLost(i)) energy += m_cEnergy.GetOf(m_cGame.GetWorld(), i);
    return energy;
  }

  double GetSpeed() const {
    double fastest = 0.0;
    for (std::size_t i = 0; i < m_stdTouched.size(); ++i)
      if (!IsLost(i)) fastest = std::max(fastest, Norm(GetVel(i)));
    return fastest;
  }

  double GetOverlap(double time) {
    double deepest = 0.0;
    for (std::size_t k = 0; k < m_cShapes.GetShapeCount(); ++k) {
      const CSceneShape& shape = m_cScene.m_stdShapes[k];
      const CShapeDesc& base = GetBase(shape.m_cDesc);
      if (base.m_bIsSensor) continue;
      if (base.m_eMotionType == eMotion::Kinematic) {
        m_cShapes.SetOffset(k, OffsetAt(shape, time));
        m_cShapes.SetOrientation(k, static_cast<double>(OrientationAt(shape, time)));
      }
      const CShapeGeometry<double> geometry = m_cShapes.GetGeometry(k);
      if (geometry.m_eSides != eSides::Both) continue; // a ball may be on its way through it
      for (std::size_t i = 0; i < m_stdTouched.size(); ++i)
        if (!IsLost(i) && DoMeet(base.m_cFilter, GetFilter(i)))
          deepest = std::max(deepest, (GetRadius(i) - Distance(geometry, GetPos(i))) / GetRadius(i));
    }
    for (std::size_t i = 0; i < m_stdTouched.size(); ++i)
      for (std::size_t j = i + 1; j < m_stdTouched.size(); ++j)
        if (!IsLost(i) && !IsLost(j) && DoMeet(GetFilter(i), GetFilter(j)))
          deepest = std::max(deepest, (GetRadius(i) + GetRadius(j) - Norm(CVec2d(GetPos(i) - GetPos(j)))) /
                                          std::min(GetRadius(i), GetRadius(j)));
    return deepest;
  }

  void NoteTouches(double time) {
    const std::size_t shapes = m_cScene.m_stdShapes.size();
    for (const CContactEvent& event : m_cGame.GetWorld().GetContacts()) {
      const std::size_t shape = event.m_cShape.m_nValue - 1;
      if (shape >= shapes || !GetBase(m_cScene.m_stdShapes[shape].m_cDesc).m_bIsSensor) continue;
      const std::size_t ball = event.m_cBall.m_nValue - 1 - shapes;
      if (m_stdTouched[ball]) continue;
      m_stdTouched[ball] = true;
      ++m_nTouched;
      m_fLastTouch = time;
    }
  }

  const CScene& m_cScene;
  const CStart& m_cStart;
  CGame m_cGame;
  CReference<double> m_cShapes; // their geometry at any time
  CEnergy m_cEnergy;
  double m_fStartEnergy = 0.0, m_fGained = 0.0, m_fSpeed = 0.0, m_fOverlap = 0.0;
  double m_fRestTime = 0.0, m_fLastTouch = 0.0;
  double m_nTouched = 0.0;
  bool m_bRests = false;
  std::vector<bool> m_stdTouched;
};

double TimeOfBallStep(const CScene& scene, const CEngine& engine, const CStart& start) {
  CGame game(scene, engine, start);
  game.SetPutBack(false);
  const std::size_t steps = CountSteps(scene, scene.m_fLasting);
  const CStopwatch stopwatch;
  for (std::size_t i = 0; i < steps; ++i)
    game.Step();
  return static_cast<double>(stopwatch.GetElapsed().count()) /
         static_cast<double>(steps * start.m_stdBalls.size());
}

void KeepGreater(std::optional<double>& greatest, double x) { greatest = std::max(greatest.value_or(x), x); }

} // namespace

std::vector<CLasting> MeasureLasting(const CScene& scene, const std::vector<CEngine>& engines,
                                     std::uint64_t seed, int trials,
                                     const std::function<void(double)>& progress) {
  std::vector<CLasting> all(engines.size());
  if (scene.m_fLasting == 0.0f) return all;
  const bool hasEnergy = KeepsOrLosesEnergy(scene),
             hasSensors =
                 std::any_of(scene.m_stdShapes.begin(), scene.m_stdShapes.end(),
                             [](const CSceneShape&shape) { return GetBase(shape.m_cDesc).m_bIsSensor; });
  std::vector<std::vector<double>> restTimes(engines.size()), flows = restTimes, ns = restTimes;
  for (int trial = 0; trial < trials; ++trial) {
    const CStart start = MakeStart(scene, seed, static_cast<std::uint64_t>(trial));
    for (std::size_t turn = 0; turn < engines.size(); ++turn) {
      const std::size_t e = (turn + static_cast<std::size_t>(trial)) % engines.size();
      CLasting& lasting = all[e];
      CLastingGame game(scene, engines[e], start);
      game.Play();
      lasting.m_nBalls += start.m_stdBalls.size();
      const std::size_t lost = game.CountLost();
      lasting.m_nLost += lost;
      if (lost < start.m_stdBalls.size()) {
        KeepGreater(lasting.m_fOverlap, game.GetDeepest());
        KeepGreater(lasting.m_fSpeed, game.GetFastest());
        if (const auto t = game.GetRestTime()) restTimes[e].push_back(*t);
      }
      if (hasEnergy) KeepGreater(lasting.m_fEnergyGained, game.GetEnergyGained());
      flows[e].push_back(game.GetFlow());
      ns[e].push_back(TimeOfBallStep(scene, engines[e], start));
      if (progress)
        progress((trial + static_cast<double>(turn + 1) / static_cast<double>(engines.size())) / trials);
    }
  }
  for (std::size_t e = 0; e < engines.size(); ++e) {
    if (restTimes[e].size() == static_cast<std::size_t>(trials))
      all[e].m_fRestTime = Summarise(restTimes[e]).m_fMedian;
    if (hasSensors) all[e].m_fFlow = Summarise(flows[e]).m_fMedian;
    all[e].m_cNsPerBallStep = MedianWithInterval(ns[e]);
  }
  return all;
}

} // namespace Shapes::Compare
