// SPDX-License-Identifier: MIT
#include "../Descs.h"
#include "Bytes.h"
#include "Fuzz.h"

#include <Shapes/Shapes.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <type_traits>
#include <vector>

namespace Shapes::Fuzz {
namespace {

// Bounds of time. Thousands of chords that all touch one ball take Box2D seconds a step, and so do thousands
// of sweeps where shapes turn hundreds of times in each.
constexpr std::size_t g_nMostShapes = 24;
constexpr std::uint64_t g_nMostPieces = 30, g_nMostEngineSteps = 150, g_nMostSweeps = 3000;
constexpr int g_nMostSteps = 24;

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
          world.GetSensor(id), world.GetCanCollide(id), world.GetUserPtr(id));
      if (world.GetMotionType(id) == eMotion::Dynamic) {
        Add(world.GetVel(id), world.GetRadius(id), world.GetMass(id));
        continue;
      }
      const CAabb2D& box = world.GetShape(id).GetAABB();
      Add(world.GetOrientation(id), world.GetRotSpeed(id), world.GetRotCenter(id), box.GetTopLeft(),
          box.GetBottomRt());
    }
  }
  /// And what the last step told.
  void AddStep(const CWorld& world) {
    for (const CContactEvent& e : world.GetContacts())
      Add(e.m_cShape, e.m_cBall, e.m_vPOI, e.m_vNorm, e.m_fSetback, e.m_fSpeed, e.m_bIsSensor);
    for (const CSensorEvent& e : world.GetSensorEvents())
      Add(e.m_cShape, e.m_cBall, e.m_bBegin);
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

/// A world and what is done to it.
class CPlayed {
public:
  explicit CPlayed(CBytes bytes) : m_cBytes(bytes) {}

  void Run() {
    if (!Make()) return;
    while (!m_cBytes.IsEmpty() && !IsLong())
      Do();
    if (!IsLong()) Step();
  }

private:
  bool Make() {
    static constexpr CEffectChoice choices[] = {g_cAutomatic, g_cApproximate, g_cContinuous};
    const unsigned kind = m_cBytes.Byte() % 5;
    CWorldDesc desc;
    m_bIsNative = kind < 3;
    if (m_bIsNative) desc.m_cEffects = choices[kind];
    desc.m_cBox2D.m_eProfile = kind == 4 ? eProfile::Tuned : eProfile::Shipped;
    desc.m_nSubsteps = 1u + m_cBytes.Byte() % 3;
    const unsigned forced = m_cBytes.Byte(), forbidden = m_cBytes.Byte();
    for (unsigned e = 0; e < static_cast<unsigned>(eEffect::Size); ++e) {
      if ((forced >> e & 1) != 0) desc.m_cEffects.m_cForced.Set(static_cast<eEffect>(e));
      if ((forbidden >> e & 1) != 0) desc.m_cEffects.m_cForbidden.Set(static_cast<eEffect>(e));
    }
    // Mostly what is usual: then the rest of the bytes matters.
    const unsigned unusual = m_cBytes.Byte();
    if ((unusual & 1) != 0) desc.m_fTimeStep = m_cBytes.Number();
    if ((unusual & 2) != 0) desc.m_vGravity = m_cBytes.Vector();
    if ((unusual & 4) != 0) desc.m_cBox2D.m_fLengthUnit = m_cBytes.Number();
    if ((unusual & 8) != 0) desc.m_cBox2D.m_fSagittaTolerance = m_cBytes.Number();
    if ((unusual & 16) != 0) desc.m_cBox2D.m_nVelocityIterations = m_cBytes.Byte() % 32u;
    if ((unusual & 32) != 0) desc.m_cBox2D.m_nPositionIterations = m_cBytes.Byte() % 32u;
    try {
      m_pWorld = GetBackend(m_bIsNative ? eBackend::Native : eBackend::Box2D)->MakeWorld(desc);
    } catch (const std::invalid_argument&) {
    }
    return m_pWorld != nullptr;
  }

  bool IsLong() const {
    const CWorldStats& stats = m_pWorld->GetStats();
    return m_nSteps >= g_nMostSteps || stats.m_nEngineSteps > g_nMostEngineSteps ||
           stats.m_nSweeps > g_nMostSweeps;
  }

  // A refusal is a std::invalid_argument, and has changed nothing.
  template <class F>
  bool Try(const F& f) {
    const CPicture before(*m_pWorld, m_stdIds);
    try {
      f();
      return true;
    } catch (const std::invalid_argument&) {
      Require(CPicture(*m_pWorld, m_stdIds) == before, "what is refused changes nothing");
      return false;
    }
  }

  CShapeId AnyId() {
    const unsigned i = m_cBytes.Byte();
    return m_stdIds.empty() ? CShapeId() : m_stdIds[i % m_stdIds.size()];
  }

  // Of shapes that are there as well as of those that were removed.
  void Do() {
    CWorld& world = *m_pWorld;
    const unsigned what = m_cBytes.Byte() % 24;
    if (what < 5) return AddAny(what);
    if (what == 5) return AddCompound();
    if (what < 10) return Step(); // the most frequent
    if (what == 10) return SaveAndGoOn();
    if (what == 11) return Load();
    if (what == 12) {
      const Vector2 g = m_cBytes.Vector();
      Try([&] { world.SetGravity(g); });
      return;
    }
    const CShapeId id = AnyId();
    const bool isThere = world.Contains(id);
    const bool took = Try([&] { Change(what, id); });
    Require(isThere || !took, "the id of what was removed is refused", id.m_nValue, "operation", what);
  }

  void Change(unsigned what, CShapeId id) {
    CWorld& world = *m_pWorld;
    switch (what) {
    case 13: return world.Remove(id);
    case 14: return world.SetPos(id, m_cBytes.Vector());
    case 15: return world.SetVel(id, m_cBytes.Vector());
    case 16: return world.SetOrientation(id, m_cBytes.Number());
    case 17: return world.SetRotSpeed(id, m_cBytes.Number());
    case 18: return world.SetRotCenter(id, m_cBytes.Vector());
    case 19: return world.SetElasticity(id, m_cBytes.Number());
    case 20: return world.SetSensor(id, m_cBytes.Flag());
    case 21: return world.SetCanCollide(id, m_cBytes.Flag());
    case 22: return world.Reset(id);
    default: return world.SetUserPtr(id, this);
    }
  }

  template <class TDesc>
  TDesc Moving(TDesc desc) {
    const unsigned flags = m_cBytes.Byte();
    desc.m_bIsSensor = (flags & 7) == 7;
    if ((flags & 16) != 0) desc.m_fElasticity = m_cBytes.Number();
    if ((flags & 8) == 0) return desc;
    const float revsPerSecond = m_cBytes.Number();
    return Turning(desc, revsPerSecond, m_cBytes.Vector());
  }
  eSides Sides() { return m_cBytes.OneOf({eSides::Both, eSides::Front, eSides::Back}); }

  CAnyShapeDesc AnyShape(unsigned what) {
    if (what == 0) return Moving(CPointDesc(m_cBytes.Vector()));
    if (what == 1) {
      const Vector2 p0 = m_cBytes.Vector(), p1 = m_cBytes.Vector();
      return Moving(Sided(CLineSegDesc(p0, p1), Sides()));
    }
    const Vector2 p = m_cBytes.Vector();
    const float r = m_cBytes.Number();
    if (what == 2) return Moving(CCircleDesc(p, r));
    const float a0 = m_cBytes.Number(), a1 = m_cBytes.Number();
    return Moving(Sided(CArcDesc(p, r, a0, a1), Sides()));
  }

  CDynamicCircleDesc AnyBall() {
    const Vector2 p = m_cBytes.Vector(), v = m_cBytes.Vector();
    const float r = m_cBytes.Number();
    CDynamicCircleDesc desc(p, r, v);
    const unsigned flags = m_cBytes.Byte();
    desc.m_bIsSensor = (flags & 7) == 7;
    if ((flags & 8) != 0) desc.m_fMass = m_cBytes.Number();
    if ((flags & 16) != 0) desc.m_fElasticity = m_cBytes.Number();
    return desc;
  }

  void AddAny(unsigned what) {
    if (m_stdIds.size() >= g_nMostShapes) return;
    const CAnyShapeDesc desc = what == 4 ? CAnyShapeDesc(AnyBall()) : AnyShape(what);
    Try([&] { m_stdIds.push_back(m_pWorld->Add(desc)); });
    RemoveIfCoarse();
  }

  void AddCompound() {
    if (m_stdIds.size() >= g_nMostShapes) return;
    std::vector<CAnyShapeDesc> descs;
    for (unsigned n = 1u + m_cBytes.Byte() % 3; n > 0; --n)
      descs.push_back(AnyShape(m_cBytes.Byte() % 4));
    const Vector2 center = m_cBytes.Vector();
    const float speed = m_cBytes.Number();
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

  void RemoveIfCoarse() {
    for (auto id = m_stdIds.rbegin(); m_pWorld->GetStats().m_nArcPieces > g_nMostPieces; ++id)
      if (m_pWorld->Contains(*id)) m_pWorld->Remove(*id);
  }

  void Step() {
    const CWorldStats before = m_pWorld->GetStats();
    m_pWorld->Step();
    ++m_nSteps;
    RequireSound(*m_pWorld);
    RequireMore(before, m_pWorld->GetStats());
    for (const CSensorEvent& e : m_pWorld->GetSensorEvents()) {
      const auto pair = std::pair(e.m_cBall, e.m_cShape);
      const bool changes = e.m_bBegin ? m_stdTouching.insert(pair).second : m_stdTouching.erase(pair) == 1;
      Require(changes, "every touch begins and ends once", e.m_cBall.m_nValue, e.m_cShape.m_nValue);
    }
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

  CPicture Picture() const { return CPicture(*m_pWorld, m_stdIds); }

  // A world that goes on, and one that goes on after it was put back, have the same bits.
  void SaveAndGoOn() {
    m_cSaved = m_pWorld->SaveState();
    m_bHasSaved = true;
    m_stdSavedTouching = m_stdTouching;
    if (!m_cBytes.Flag()) return;
    std::vector<CPicture> pictures[2];
    const unsigned steps = 1u + m_cBytes.Byte() % 4;
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
    m_stdTouching = m_stdSavedTouching;
  }

  CBytes m_cBytes;
  std::unique_ptr<CWorld> m_pWorld;
  bool m_bIsNative = true, m_bHasSaved = false;
  int m_nSteps = 0;
  std::vector<CShapeId> m_stdIds; // of all that was ever added
  std::set<std::pair<CShapeId, CShapeId>> m_stdTouching, m_stdSavedTouching;
  CSavedState m_cSaved;
};

} // namespace

void FuzzWorld(std::span<const std::uint8_t> bytes) { CPlayed(CBytes(bytes)).Run(); }

} // namespace Shapes::Fuzz
