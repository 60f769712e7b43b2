// SPDX-License-Identifier: MIT
// A world to which anything at all is done, and what has to hold then. A source says what is done, and with
// which values: the bytes of a fuzzer, or random numbers.
#pragma once

#include "Fuzz.h"

#include <Shapes/Shapes.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace Shapes::Fuzz {

/// Everything that can be asked of a world, bit by bit.
class CPicture {
public:
  CPicture() = default;
  CPicture(const CWorld& world, const std::vector<CShapeId>& ids) {
    Add(world.GetDesc().m_vGravity, world.GetBallIds().size());
    for (const CShapeId id : ids) {
      const bool isThere = world.Contains(id);
      Add(id, isThere);
      if (!isThere) continue;
      Add(world.GetShapeType(id), world.GetMotionType(id), world.GetPos(id), world.GetElasticity(id),
          world.GetSensor(id), world.GetCanCollide(id), world.GetUserPtr(id), world.GetFilter(id).m_nCategory,
          world.GetFilter(id).m_nMask);
      if (world.GetMotionType(id) != eMotion::Static) Add(world.GetVel(id));
      if (world.GetMotionType(id) == eMotion::Dynamic) {
        Add(world.GetRadius(id), world.GetMass(id));
        continue;
      }
      const CAabb2D& box = world.GetShape(id).GetAABB();
      const CMotionLimits limits = world.GetLimits(id);
      Add(world.GetOrientation(id), world.GetRotSpeed(id), world.GetRotCenter(id), box.GetTopLeft(),
          box.GetBottomRt(), limits.m_fLeastAngle, limits.m_fMostAngle, limits.m_vLeastCenter,
          limits.m_vMostCenter);
    }
  }
  /// And what the last step told.
  void AddStep(const CWorld& world) {
    for (const CContactEvent& e : world.GetContacts())
      Add(e.m_cShape, e.m_cBall, e.m_vPOI, e.m_vNorm, e.m_fSetback, e.m_fSpeed, e.m_bIsSensor, e.m_fImpulse);
    for (const CSensorEvent& e : world.GetSensorEvents())
      Add(e.m_cShape, e.m_cBall, e.m_bBegin);
    for (const CTouchEvent& e : world.GetTouchEvents())
      Add(e.m_cShape, e.m_cBall, e.m_bBegin);
    for (const CShapeId id : world.GetHaltedBalls())
      Add(id);
  }
  friend bool operator==(const CPicture&, const CPicture&) = default;

private:
  template <class... T>
  void Add(const T&... values) {
    (AddOne(values), ...);
  }
  void AddOne(const Vector2& v) { Add(v.x(), v.y()); }
  void AddOne(const CShapeId& id) { Add(id.m_nValue); }
  template <class T>
  void AddOne(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, float>);
    const auto* pBytes = reinterpret_cast<const unsigned char*>(&value);
    m_stdBytes.insert(m_stdBytes.end(), pBytes, pBytes + sizeof(T));
  }

  std::vector<unsigned char> m_stdBytes;
};

/// The operations that CWorldTrial::Do knows.
inline constexpr unsigned g_nOperations = 24;

/// @tparam TSource  gives values of each kind: Shape, Parts, Pos, Vel, Gravity, Angle, RotSpeed, Elasticity,
///                  Flag, Below
template <class TSource>
class CWorldTrial {
public:
  explicit CWorldTrial(TSource& source) : m_cSource(source) {}

  /// Whether the engine takes the description.
  bool Make(const CBackend& backend, const CWorldDesc& desc) {
    return Try([&] { m_pWorld = backend.MakeWorld(desc); });
  }
  CWorld& GetWorld() const { return *m_pWorld; }
  std::size_t CountShapes() const { return m_stdIds.size(); } // that were ever added
  int GetSteps() const { return m_nSteps; }

  /// To shapes that are there as well as to those that were removed. The first six add some.
  void Do(unsigned operation) {
    CWorld& world = *m_pWorld;
    if (operation < 5) return Add(m_cSource.Shape(operation));
    if (operation == 5) return AddCompound();
    if (operation < 10) return Step(); // the most frequent
    if (operation == 10) return SaveAndGoOn();
    if (operation == 11) return Load();
    if (operation == 12) {
      const Vector2 g = m_cSource.Gravity();
      Try([&] { world.SetGravity(g); });
      return;
    }
    const unsigned i = m_cSource.Below(256);
    const CShapeId id = m_stdIds.empty() ? CShapeId() : m_stdIds[i % m_stdIds.size()];
    const bool isThere = world.Contains(id);
    const bool took = Try([&] { Change(operation, id); });
    Require(isThere || !took, "the id of what was removed is refused", id.m_nValue, "operation", operation);
  }

  void Add(const CAnyShapeDesc& desc) {
    Try([&] { m_stdIds.push_back(m_pWorld->Add(desc)); });
    RemoveIfCoarse();
  }

  void Step() {
    const CWorldStats before = m_pWorld->GetStats();
    m_pWorld->Step();
    ++m_nSteps;
    RequireSound(*m_pWorld);
    RequireMore(before, m_pWorld->GetStats());
    for (const CShapeId id : m_stdIds)
      Require(!m_pWorld->Contains(id) || m_pWorld->GetPos(id).allFinite(), "a shape has a finite place",
              id.m_nValue);
    for (const CTouchEvent& e : m_pWorld->GetTouchEvents())
      m_nSolidBegins += Keep(m_cNow.m_stdSolid, e);
    CPairs begun;
    for (const CSensorEvent& e : m_pWorld->GetSensorEvents()) {
      const bool isBegin = Keep(m_cNow.m_stdSensed, e);
      m_nBegins += isBegin;
      m_nCrossed += !isBegin && begun.contains({e.m_cBall, e.m_cShape});
      if (isBegin) begun.emplace(e.m_cBall, e.m_cShape);
    }
    begun.insert(m_cNow.m_stdSensed.begin(), m_cNow.m_stdSensed.end());
    RequireContactsOf(begun, m_pWorld->GetStats().m_nSubsteps > before.m_nSubsteps + 1);
  }

  using CPairs = std::set<std::pair<CShapeId, CShapeId>>; ///< Ball, shape.
  /// Touches of sensors that have begun and not ended.
  const CPairs& GetSensed() const { return m_cNow.m_stdSensed; }
  const CPairs& GetTouching() const { return m_cNow.m_stdSolid; }

  std::uint64_t m_nAccepted = 0, m_nRefused = 0;                   ///< Calls.
  std::uint64_t m_nBegins = 0, m_nCrossed = 0, m_nSolidBegins = 0; ///< Touches; those that end in their step.
  std::uint64_t m_nLoads = 0;

private:
  // A refusal is a std::invalid_argument, and has changed nothing.
  template <class F>
  bool Try(const F& f) {
    const CPicture before = Picture();
    try {
      f();
      ++m_nAccepted;
      return true;
    } catch (const std::invalid_argument&) {
      Require(Picture() == before, "what is refused changes nothing");
      ++m_nRefused;
      return false;
    }
  }

  // Whether it is a begin.
  template <class TEvent>
  static bool Keep(CPairs& pairs, const TEvent& e) {
    const std::pair pair(e.m_cBall, e.m_cShape);
    const bool changes = e.m_bBegin ? pairs.insert(pair).second : pairs.erase(pair) == 1;
    Require(changes, "every touch begins and ends once", e.m_cBall.m_nValue, e.m_cShape.m_nValue);
    return e.m_bBegin;
  }

  // The contacts of sensors are those that touch, or touched in this step: each pair that does has one of
  // each substep, or of each part of one that is cut at stops; none where the world may not report contacts.
  void RequireContactsOf(const CPairs& touching, bool isCut) const {
    if (m_pWorld->GetDesc().m_cEffects.m_cForbidden.Has(eEffect::Events))
      return Require(m_pWorld->GetContacts().empty(), "no contacts without Events");
    CPairs contacts;
    for (const CContactEvent& c : m_pWorld->GetContacts()) {
      if (!c.m_bIsSensor) continue;
      const bool isNew = contacts.emplace(c.m_cBall, c.m_cShape).second;
      Require(isNew || isCut, "a pair has one contact", c.m_cBall.m_nValue, c.m_cShape.m_nValue);
      Require(m_pWorld->GetSensor(c.m_cBall) || m_pWorld->GetSensor(c.m_cShape), "one of them is a sensor");
      Require(m_pWorld->GetCanCollide(c.m_cBall) && m_pWorld->GetCanCollide(c.m_cShape), "both can collide");
    }
    Require(std::includes(contacts.begin(), contacts.end(), touching.begin(), touching.end()),
            "what touches a sensor has a contact");
  }

  void Change(unsigned operation, CShapeId id) {
    CWorld& world = *m_pWorld;
    switch (operation) {
    case 13: return world.Remove(id);
    case 14: return world.SetPos(id, m_cSource.Pos());
    case 15: return world.SetVel(id, m_cSource.Vel());
    case 16: return world.SetOrientation(id, m_cSource.Angle());
    case 17: return world.SetRotSpeed(id, m_cSource.RotSpeed());
    case 18: return world.SetRotCenter(id, m_cSource.Pos());
    case 19: return world.SetElasticity(id, m_cSource.Elasticity());
    case 20: return world.SetSensor(id, m_cSource.Flag());
    case 21: return world.SetCanCollide(id, m_cSource.Flag());
    case 22: return world.Reset(id);
    default: return ChangeRarely(id);
    }
  }

  CFilter MakeFilter() {
    const unsigned category = m_cSource.Below(4), mask = m_cSource.Below(4);
    return {static_cast<std::uint16_t>(category), static_cast<std::uint16_t>(mask)};
  }

  CMotionLimits MakeLimits() {
    if (m_cSource.Flag()) return {};
    if (m_cSource.Flag()) {
      const float a = m_cSource.Angle(), b = m_cSource.Angle();
      return CMotionLimits::OfAngle(a, b);
    }
    const Vector2 a = m_cSource.Pos(), b = m_cSource.Pos();
    return CMotionLimits::OfCenter(a, b);
  }

  void ChangeRarely(CShapeId id) {
    switch (m_cSource.Below(3)) {
    case 0: return m_pWorld->SetUserPtr(id, this);
    case 1: return m_pWorld->SetFilter(id, MakeFilter());
    default: return m_pWorld->SetLimits(id, MakeLimits());
    }
  }

  void AddCompound() {
    const std::vector<CAnyShapeDesc> descs = m_cSource.Parts();
    const Vector2 center = m_cSource.Pos();
    const float speed = m_cSource.RotSpeed();
    std::vector<CShapeId> ids;
#ifdef SHAPES_PLANTED_FAULT
    // One by one: what comes before the one that is refused has been added then.
    Try([&] {
      for (const CAnyShapeDesc& desc : descs)
        m_stdIds.push_back(m_pWorld->AddCompound({&desc, 1}, center, speed).front());
    });
#else
    Try([&] { ids = m_pWorld->AddCompound(descs, center, speed); });
#endif
    m_stdIds.insert(m_stdIds.end(), ids.begin(), ids.end());
    RemoveIfCoarse();
  }

  // Thousands of chords that all touch one ball take Box2D seconds a step.
  void RemoveIfCoarse() {
    constexpr std::uint64_t mostPieces = 30;
    for (auto id = m_stdIds.rbegin(); m_pWorld->GetStats().m_nArcPieces > mostPieces; ++id)
      if (m_pWorld->Contains(*id)) m_pWorld->Remove(*id);
  }

  static void RequireMore(const CWorldStats& a, const CWorldStats& b) {
    using C = CWorldStats;
    static constexpr std::uint64_t C::*counters[] = {
        &C::m_nSteps,        &C::m_nSubsteps,   &C::m_nBallsAccelerated, &C::m_nShapesTurned,
        &C::m_nShapeTests,   &C::m_nBallTests,  &C::m_nSweeps,           &C::m_nBallsSwept,
        &C::m_nBallsHalted,  &C::m_nMovesLost,  &C::m_nSensorTests,      &C::m_nContacts,
        &C::m_nSensorHits,   &C::m_nReported,   &C::m_nSpeedsCapped,     &C::m_nMovesClamped,
        &C::m_nTurnsClamped, &C::m_nEngineSteps};
    for (std::size_t i = 0; i < std::size(counters); ++i)
      Require(b.*counters[i] >= a.*counters[i] + (i < 2), "counters never go back", i, a.*counters[i],
              b.*counters[i]);
    for (std::size_t i = 0; i < a.m_stdSubstepsWith.size(); ++i)
      Require(a.m_stdSubstepsWith[i] <= b.m_stdSubstepsWith[i] && b.m_stdSubstepsWith[i] <= b.m_nSubsteps,
              "substeps with an effect never go back and are substeps", i);
  }

  CPicture Picture() const { return m_pWorld ? CPicture(*m_pWorld, m_stdIds) : CPicture(); }

  // A world that goes on, and one that goes on after it was put back, have the same bits.
  void SaveAndGoOn() {
    m_cSaved = m_pWorld->SaveState();
    m_bHasSaved = true;
    m_cSavedTouches = m_cNow;
    if (!m_cSource.Flag()) return;
    std::vector<CPicture> pictures[2];
    const unsigned steps = 1u + m_cSource.Below(4);
    for (std::vector<CPicture>& way : pictures) {
      if (&way != pictures) Load();
      way.push_back(Picture());
      for (unsigned i = 0; i < steps; ++i) {
        Step();
        way.push_back(Picture());
        way.back().AddStep(*m_pWorld);
      }
    }
    Require(pictures[0] == pictures[1], "a saved state goes on with the same bits");
  }

  void Load() {
    if (!m_bHasSaved) {
      Require(!Try([&] { m_pWorld->LoadState(m_cSaved); }), "a state that nobody saved is refused");
      return;
    }
    m_pWorld->LoadState(m_cSaved);
    m_cNow = m_cSavedTouches;
    ++m_nLoads;
  }

  TSource& m_cSource;
  std::unique_ptr<CWorld> m_pWorld;
  bool m_bHasSaved = false;
  int m_nSteps = 0;
  std::vector<CShapeId> m_stdIds; // of all that was ever added
  struct {
    CPairs m_stdSensed, m_stdSolid;
  } m_cNow, m_cSavedTouches;
  CSavedState m_cSaved;
};

} // namespace Shapes::Fuzz
