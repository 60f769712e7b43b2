// SPDX-License-Identifier: MIT
#include "DestructionWatch.h"

#include <mutex>

namespace Shapes::Box2D {
namespace {

// All ties of all worlds: b2Worlds may live in several threads.
struct CWatchRegistry {
  std::mutex m_stdMutex;
  std::unordered_map<const b2Shape*, CDestructionWatch*> m_stdWatches;
};

// Never destroyed: a b2World may be a static object that outlives anything here.
CWatchRegistry& WatchRegistry() {
  static CWatchRegistry& registry = *new CWatchRegistry;
  return registry;
}

} // namespace

CDestructionWatch::~CDestructionWatch() {
  const std::scoped_lock lock(WatchRegistry().m_stdMutex);
  for (const auto& [pShape, id] : m_stdIds)
    WatchRegistry().m_stdWatches.erase(pShape);
}

void CDestructionWatch::Watch(const b2Shape& shape, CShapeId id) {
  m_stdIds[&shape] = id;
  const std::scoped_lock lock(WatchRegistry().m_stdMutex);
  WatchRegistry().m_stdWatches[&shape] = this;
}

void CDestructionWatch::OnDestroyed(const b2Shape& shape) noexcept {
  CDestructionWatch* pWatch = nullptr;
  {
    const std::scoped_lock lock(WatchRegistry().m_stdMutex);
    const auto it = WatchRegistry().m_stdWatches.find(&shape);
    if (it == WatchRegistry().m_stdWatches.end()) return;
    pWatch = it->second;
    WatchRegistry().m_stdWatches.erase(it);
  }
  const auto node = pWatch->m_stdIds.extract(&shape);
  pWatch->m_stdOnLost(node.mapped());
}

} // namespace Shapes::Box2D
