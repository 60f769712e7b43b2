// SPDX-License-Identifier: MIT
#pragma once

#include <box2d/box2d.h>

#include <utility>

#include "../contact/ContactGatherer.h"

namespace Shapes::Box2D {

/// As long as it lives a variable has this value, and then the one of before.
template <class T>
class CDuring {
public:
  CDuring(T& variable, T value) : m_cVariable(variable), m_cBefore(std::exchange(variable, value)) {}
  ~CDuring() { m_cVariable = m_cBefore; }
  CDuring(const CDuring&) = delete;
  CDuring& operator=(const CDuring&) = delete;

private:
  T& m_cVariable;
  T m_cBefore;
};

/// Stands before the contact listener of a game, and passes everything on to it. A b2World, or
/// another listener that passes on in turn, may keep its address and call it at any time: it is never
/// destroyed, but becomes a shell of a few bytes that only passes on.
class CListenerChain final : public b2ContactListener {
public:
  /// A new one before the present listener of the b2World.
  static CListenerChain* Install(b2World& world);
  /// Whether the b2World calls it, be it by way of others of this class.
  bool IsCalledBy(const b2World& world) const;
  /// Comes before the listener that was put in its place. Not itself, if that one may pass on to it.
  CListenerChain* InstallAgain(b2World& world);
  /// Puts back the listener before which it came.
  void TakeOut(b2World& world);

  /// The gatherer gets contacts before the game's listener; may be nullptr.
  void SetGatherer(CContactGatherer* p) { m_pGatherer = p; }
  /// Whether the game's listener is at work.
  bool IsInside() const { return m_pInside != nullptr; }

  void BeginContact(b2Contact* pContact) override;
  void EndContact(b2Contact* pContact) override;
  void PreSolve(b2Contact* pContact, const b2Manifold* pOld) override;
  void PostSolve(b2Contact* pContact, const b2ContactImpulse* pImpulse) override;

private:
  explicit CListenerChain(b2ContactListener* pNext) : m_pNext(pNext) {}
  template <class F>
  void PassOn(b2Contact* pContact, F f);

  b2ContactListener* m_pNext;
  CContactGatherer* m_pGatherer = nullptr;
  b2Contact* m_pInside = nullptr; // of which the game's listener is told
};

} // namespace Shapes::Box2D
