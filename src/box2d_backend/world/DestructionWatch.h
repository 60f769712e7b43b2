// SPDX-License-Identifier: MIT
// Detects that the game has destroyed a body, or the b2World with all its bodies. Box2D does not report the
// latter, but it runs the destructors of the shapes of its fixtures in either case.
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <functional>
#include <new>
#include <type_traits>
#include <unordered_map>

namespace Shapes::Box2D {

/// The shapes of fixtures that one world watches over.
class CDestructionWatch {
public:
  /// @param onLost  called with the owner of a watched shape that is destroyed; within a function of Box2D,
  /// so it must not call any and must not throw
  explicit CDestructionWatch(std::function<void(CShapeId)> onLost) : m_stdOnLost(std::move(onLost)) {}
  ~CDestructionWatch();
  CDestructionWatch(const CDestructionWatch&) = delete;
  CDestructionWatch& operator=(const CDestructionWatch&) = delete;

  /// @param shape  of a fixture that was made from a CWatched
  void Watch(const b2Shape& shape, CShapeId id);
  /// While any is left, so is the b2World.
  bool IsAnyLeft() const { return !m_stdIds.empty(); }

  /// Called by the destructor of any CWatched, most of which have no owner.
  static void OnDestroyed(const b2Shape& shape) noexcept;

private:
  std::function<void(CShapeId)> m_stdOnLost;
  std::unordered_map<const b2Shape*, CShapeId> m_stdIds;
};

/// A shape of Box2D whose destructor is heard. It holds nothing more than TShape does, because Box2D frees
/// the bytes of a TShape; who waits for it is found by its address.
template <class TShape>
class CWatched final : public TShape {
public:
  CWatched() = default;
  CWatched(const CWatched&) = default;
  CWatched& operator=(const CWatched&) = delete;
  ~CWatched() override { CDestructionWatch::OnDestroyed(*this); }

  b2Shape* Clone(b2BlockAllocator* pAllocator) const override {
    static_assert(sizeof(CWatched) == sizeof(TShape));
    void* pMemory = pAllocator->Allocate(static_cast<int32>(sizeof(TShape)));
    if constexpr (std::is_same_v<TShape, b2ChainShape>) { // a copy would share its vertices
      auto* pChain = new (pMemory) CWatched;
      pChain->CreateChain(this->m_vertices, this->m_count, this->m_prevVertex, this->m_nextVertex);
      return pChain;
    } else {
      return new (pMemory) CWatched(*this);
    }
  }
};

} // namespace Shapes::Box2D
