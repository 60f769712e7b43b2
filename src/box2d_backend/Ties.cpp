// SPDX-License-Identifier: MIT
#include "Ties.h"

#include <mutex>

namespace Shapes::Box2D {
namespace {

// All ties of all worlds: b2Worlds may live in several threads.
struct CTieRegistry {
  std::mutex m_stdMutex;
  std::unordered_map<const b2Shape*, CTies*> m_stdTies;
};

// Never destroyed: a b2World may be a static object that outlives anything here.
CTieRegistry& TieRegistry() {
  static CTieRegistry& registry = *new CTieRegistry;
  return registry;
}

} // namespace

CTies::~CTies() {
  const std::scoped_lock lock(TieRegistry().m_stdMutex);
  for (const auto& [pShape, id] : m_stdIds)
    TieRegistry().m_stdTies.erase(pShape);
}

void CTies::Tie(const b2Shape& shape, CShapeId id) {
  m_stdIds[&shape] = id;
  const std::scoped_lock lock(TieRegistry().m_stdMutex);
  TieRegistry().m_stdTies[&shape] = this;
}

void CTies::OnDestroyed(const b2Shape& shape) noexcept {
  CTies* pTies = nullptr;
  {
    const std::scoped_lock lock(TieRegistry().m_stdMutex);
    const auto it = TieRegistry().m_stdTies.find(&shape);
    if (it == TieRegistry().m_stdTies.end()) return;
    pTies = it->second;
    TieRegistry().m_stdTies.erase(it);
  }
  const auto node = pTies->m_stdIds.extract(&shape);
  pTies->m_stdOnLost(node.mapped());
}

} // namespace Shapes::Box2D
