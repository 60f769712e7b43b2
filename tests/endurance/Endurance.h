// SPDX-License-Identifier: MIT
// A scene that is played for long, and what must not change by that. docs/testing.md derives the bounds.
#pragma once

#include "Played.h"
#include "Testing.h"

#include <chrono>
#include <numeric>

namespace Shapes::Tests {

/// The memory that the program holds: its operator new and delete count. Blocks that are allocated now (a
/// vector that grows stays one block, a leak does not), bytes in them, and blocks that were ever allocated.
std::size_t CountLiveBlocks();
std::size_t CountLiveBytes();
std::size_t CountAllocations();

struct CFigures {
  std::size_t m_nSteps = 0;
  std::size_t m_nContacts = 0;
  std::size_t m_nPairContacts = 0; ///< of two balls
  std::size_t m_nDrained = 0;
  std::size_t m_nEscaped = 0;
  float m_fFastest = 0.0f; ///< the highest speed of a ball after a step
  double m_fSeconds = 0.0; ///< that it took

  /// Of the kinetic energy of all balls, relative; and the most that hits of balls can make it by rounding.
  double m_fEnergyDrift = 0.0, m_fEnergyBound = 0.0;
  /// Sum of what steps without a contact changed of the energy that they keep, for mass 1; and the most that
  /// is rounding.
  double m_fFlightDrift = 0.0, m_fFlightBound = 0.0;
  /// How far apart the mean kinetic energies of the first and the second half are, in standard deviations.
  double m_fHalvesApart = 0.0;

  /// More than after the first tenth, at most.
  std::ptrdiff_t m_nBlocksMore = 0, m_nBytesMore = 0;
  std::size_t m_nBlocks = 0, m_nBytes = 0; ///< after the first tenth

  /// Whether a game that was loaded from what was saved in the middle went on with the same bits.
  bool m_bSameAfterLoad = false;
};

/// The fault that a control puts into a run.
struct CMeddling {
  std::function<void(CPlayed&, std::size_t step)> m_Before; ///< each step
  std::function<void(CPlayed&)> m_Loaded;                   ///< the game that was loaded
};

// Half an ulp of 1: what rounding to float changes at most, relative.
inline constexpr double g_fUnit = 0x1p-24;
// A hit of two balls changes the sum of their energies by this share of it at most.
inline constexpr double g_fHitRounding = 32.0 * g_fUnit;
// A step without a hit changes what it keeps by this share of its size at most.
inline constexpr double g_fFlightRounding = 4.0 * g_fUnit;
inline constexpr std::size_t g_nBatches = 20;

class CWatch {
public:
  explicit CWatch(const CPlayed& played) : m_cWorld(played.GetWorld()), m_nShapes(played.GetShapes().size()) {
    const CWorldDesc& desc = m_cWorld.GetDesc();
    m_fStep = Wide(desc.m_fTimeStep);
    m_bIsParabola = !desc.m_cEffects.m_cForbidden.Has(eEffect::Continuous);
    // The gravity as it acts: in semi-implicit steps what is added to the velocity is rounded.
    m_vGravity =
        m_bIsParabola ? Wide(desc.m_vGravity) : Vector2d(Wide(desc.m_vGravity * desc.m_fTimeStep) / m_fStep);
    m_fEnergy0 = GetEnergy();
  }

  double GetEnergy() const { return Shapes::GetEnergy(m_cWorld, 0.0); } // of motion; all masses are 1

  void Before() {
    m_stdPos.assign(m_cWorld.GetBallPositions().begin(), m_cWorld.GetBallPositions().end());
    m_stdVel.assign(m_cWorld.GetBallVelocities().begin(), m_cWorld.GetBallVelocities().end());
  }

  void After(CFigures& figures) {
    m_stdMet.assign(m_stdPos.size(), false);
    for (const CContactEvent& contact : m_cWorld.GetContacts()) {
      ++figures.m_nContacts;
      Meet(contact.m_cBall);
      if (contact.m_cShape.m_nValue <= m_nShapes) continue;
      ++figures.m_nPairContacts;
      Meet(contact.m_cShape);
      const double energy =
          EnergyOf(m_cWorld, contact.m_cBall, 0.0, 0.0) + EnergyOf(m_cWorld, contact.m_cShape, 0.0, 0.0);
      m_fHits += energy * energy;
    }
    for (std::size_t i = 0; i < m_stdPos.size(); ++i) {
      const Vector2 &p = m_cWorld.GetBallPositions()[i], &v = m_cWorld.GetBallVelocities()[i];
      figures.m_fFastest = std::max(figures.m_fFastest, v.norm());
      if (m_stdMet[i]) continue;
      figures.m_fFlightDrift += Kept(p, v) - Kept(m_stdPos[i], m_stdVel[i]);
      figures.m_fFlightBound += g_fFlightRounding * SizeOfKept(p, v);
    }
  }

  void Finish(CFigures& figures) const {
    figures.m_fEnergyDrift = GetEnergy() / m_fEnergy0 - 1.0;
    figures.m_fEnergyBound = g_fHitRounding * std::sqrt(m_fHits) / m_fEnergy0;
  }

private:
  void Meet(CShapeId ball) { m_stdMet[ball.m_nValue - 1 - m_nShapes] = true; }

  // Parabolas keep the energy, semi-implicit steps that plus half of what gravity adds in a step.
  double Kept(const Vector2& p, const Vector2& v) const {
    const double energy = 0.5 * Wide(v).squaredNorm() - m_vGravity.dot(Wide(p));
    return m_bIsParabola ? energy : energy + 0.5 * m_fStep * m_vGravity.dot(Wide(v));
  }
  double SizeOfKept(const Vector2& p, const Vector2& v) const {
    const double g = m_vGravity.norm(), speed = Wide(v.norm()) + g * m_fStep;
    return speed * speed + g * Wide(p.norm());
  }

  const CWorld& m_cWorld;
  std::size_t m_nShapes;
  double m_fStep;
  bool m_bIsParabola;
  Vector2d m_vGravity;
  double m_fEnergy0;
  double m_fHits = 0.0;
  std::vector<Vector2> m_stdPos, m_stdVel;
  std::vector<bool> m_stdMet;
};

inline void LookAtMemory(CFigures& figures) {
  const auto more = [](std::size_t now, std::size_t then) { return static_cast<std::ptrdiff_t>(now - then); };
  figures.m_nBlocksMore = std::max(figures.m_nBlocksMore, more(CountLiveBlocks(), figures.m_nBlocks));
  figures.m_nBytesMore = std::max(figures.m_nBytesMore, more(CountLiveBytes(), figures.m_nBytes));
}

inline double Mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

inline double HalvesApart(std::span<const double> batches) {
  double squares = 0.0, difference = 0.0;
  for (const auto& half : {batches.first(batches.size() / 2), batches.last(batches.size() / 2)}) {
    const double mean = Mean(half);
    difference = mean - difference;
    for (const double value : half)
      squares += (value - mean) * (value - mean);
  }
  const auto n = static_cast<double>(batches.size());
  const double variance = squares / (n - 2.0) * (4.0 / n); // of the difference of both means
  return variance > 0.0 ? std::abs(difference) / std::sqrt(variance) : 0.0;
}

/// @param steps  200 at least
inline CFigures Endure(const Compare::CScene& scene, const CEffectChoice& effects, std::size_t steps,
                       const CMeddling& meddling = {}) {
  const auto start = std::chrono::steady_clock::now();
  CPlayed played(scene, effects);
  CWatch watch(played);
  CFigures figures;
  std::vector<double> batches(g_nBatches, 0.0);
  std::optional<CPlayed::CSaved> saved;
  CHash hash, loadedHash;
  // The game that is saved in the middle goes on for a tenth, and then the one that is loaded does.
  const std::size_t middle = steps / 2, tail = steps / 10;
  for (std::size_t i = 0; i < steps; ++i) {
    if (i == steps / 10) figures.m_nBlocks = CountLiveBlocks(), figures.m_nBytes = CountLiveBytes();
    // The state saved in the middle is held for a while.
    if (i > steps / 10 && !saved && i % (steps / 100) == 0) LookAtMemory(figures);
    if (i == middle) saved = played.Save();
    watch.Before();
    if (meddling.m_Before) meddling.m_Before(played, i);
    played.Step();
    watch.After(figures);
    batches[i * g_nBatches / steps] += watch.GetEnergy();
    if (i >= middle && i < middle + tail) AddTo(hash, played.GetWorld());
    if (i == middle + tail) {
      CPlayed loaded(scene, effects);
      loaded.Load(*saved);
      saved.reset();
      if (meddling.m_Loaded) meddling.m_Loaded(loaded);
      for (std::size_t j = middle; j < middle + tail; ++j) {
        if (meddling.m_Before) meddling.m_Before(loaded, j);
        loaded.Step();
        AddTo(loadedHash, loaded.GetWorld());
      }
    }
  }
  LookAtMemory(figures);
  watch.Finish(figures);
  figures.m_nSteps = steps;
  figures.m_nDrained = played.GetDrained();
  figures.m_nEscaped = played.GetEscaped();
  figures.m_fHalvesApart = HalvesApart(batches);
  figures.m_bSameAfterLoad = hash.Get() == loadedHash.Get();
  figures.m_fSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return figures;
}

} // namespace Shapes::Tests
