// SPDX-License-Identifier: MIT
#include "ListenerChain.h"

#include <mutex>
#include <unordered_map>

namespace Shapes::Box2D {
namespace {

// All of them, by address: what a b2World has as its listener may be one, or any listener of a game, which
// may be gone already and must not be looked at.
struct CChainRegistry {
  std::mutex m_stdMutex;
  std::unordered_map<const b2ContactListener*, CListenerChain*> m_stdChains;

  CListenerChain* Find(const b2ContactListener* p) const {
    const auto it = m_stdChains.find(p);
    return it == m_stdChains.end() ? nullptr : it->second;
  }
};

// Never destroyed, as a b2World may outlive anything here; what it points to is not lost.
CChainRegistry& ChainRegistry() {
  static CChainRegistry& registry = *new CChainRegistry;
  return registry;
}

b2ContactListener* Installed(const b2World& world) { return world.GetContactManager().m_contactListener; }

} // namespace

CListenerChain* CListenerChain::Install(b2World& world) {
  auto* pChain = new CListenerChain(Installed(world));
  {
    const std::scoped_lock lock(ChainRegistry().m_stdMutex);
    ChainRegistry().m_stdChains[pChain] = pChain;
  }
  world.SetContactListener(pChain);
  return pChain;
}

bool CListenerChain::IsCalledBy(const b2World& world) const {
  const std::scoped_lock lock(ChainRegistry().m_stdMutex);
  const CListenerChain* p = ChainRegistry().Find(Installed(world));
  while (p != nullptr && p != this)
    p = ChainRegistry().Find(p->m_pNext);
  return p != nullptr;
}

CListenerChain* CListenerChain::InstallAgain(b2World& world) {
  // Games that install their listener in every step shall not get a new one each time.
  if (Installed(world) != m_pNext) return Install(world);
  world.SetContactListener(this);
  return this;
}

void CListenerChain::TakeOut(b2World& world) {
  if (Installed(world) == this) world.SetContactListener(m_pNext);
  const std::scoped_lock lock(ChainRegistry().m_stdMutex);
  for (const auto& [pListener, pChain] : ChainRegistry().m_stdChains)
    if (pChain->m_pNext == this) pChain->m_pNext = m_pNext;
}

template <class F>
void CListenerChain::PassOn(b2Contact* pContact, F f) {
  // A listener that passes on to this one, and to which this one passes on, would go round for ever. Where a
  // game destroys a body while it is told of the end of a contact, it is told of the ends of others.
  if (m_pNext == nullptr || m_pInside == pContact) return;
  const CDuring inside(m_pInside, pContact);
  f(*m_pNext);
}

void CListenerChain::BeginContact(b2Contact* pContact) {
  PassOn(pContact, [&](b2ContactListener& next) { next.BeginContact(pContact); });
}

void CListenerChain::EndContact(b2Contact* pContact) {
  PassOn(pContact, [&](b2ContactListener& next) { next.EndContact(pContact); });
}

void CListenerChain::PreSolve(b2Contact* pContact, const b2Manifold* pOld) {
  if (m_pInside != nullptr) return;
  if (m_pGatherer != nullptr) {
    m_pGatherer->Remember(*pContact);
    m_pGatherer->PreSolve(pContact, pOld);
  }
  const bool wasEnabled = pContact->IsEnabled();
  PassOn(pContact, [&](b2ContactListener& next) { next.PreSolve(pContact, pOld); });
  // The game may disable contacts, and may have destroyed the gatherer, too.
  if (m_pGatherer == nullptr) return;
  if (pContact->IsEnabled())
    m_pGatherer->CollideWithOther(*pContact);
  else if (wasEnabled)
    m_pGatherer->Pass();
}

void CListenerChain::PostSolve(b2Contact* pContact, const b2ContactImpulse* pImpulse) {
  if (m_pInside != nullptr) return;
  if (m_pGatherer != nullptr) m_pGatherer->PostSolve(pContact, pImpulse);
  PassOn(pContact, [&](b2ContactListener& next) { next.PostSolve(pContact, pImpulse); });
}

} // namespace Shapes::Box2D
