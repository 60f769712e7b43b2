// SPDX-License-Identifier: MIT
#pragma once

#include "../../geometry/AabbTree.h"
#include "../../geometry/ShapeGeometry.h"
#include "../../world/WorldState.h"

#include <cstdint>
#include <memory>
#include <vector>

#include "ShapeGrid.h"

namespace Shapes::Native {

using namespace Geometry;

/// A shape that is no sensor.
struct CSolidShape {
  CShapeId m_cId;
  CShape* m_pShape;
};

/// The solid shapes of a world in the order of the plain loop (points by id, then the others by id), with
/// boxes around them: kinematic shapes apart from static ones, so that only they are boxed anew.
class CStaticBroadPhase {
public:
  /// Takes in the shapes that are no sensors.
  void Build(const std::vector<CShapeEntry>& shapes);
  /// A shape was added to the world, the last one in the order of ids. It gets its place behind the others.
  /// @returns whether it could: the answer for a kinematic shape, for a point, and where several have come
  ///          since all was built, is no
  bool Add(const CShapeEntry& entry);
  /// A shape was removed from the world. It is kept in its place and meets nothing, until it is worth it to
  /// build all anew.
  /// @returns whether it could: the answer for a kinematic shape, and where many are kept, is no
  bool Remove(std::unique_ptr<CShape> pShape);
  /// A shape has another pose or rotation speed.
  void Update(const CShapeEntry& entry);

  std::size_t Size() const { return m_stdByOrder.size(); }
  /// Whether any shape moves, and whether one may meet this box where it moves (after BoxKinematic).
  bool IsAnyMoving() const;
  bool MovesNear(const CAabb2D& box) const;
  const CSolidShape& Get(std::uint32_t order) const { return m_stdByOrder[order]; }

  /// Puts boxes around all that the kinematic shapes sweep in the next dt seconds; with 0 as they are now.
  void BoxKinematic(float dt);
  /// Appends the orders of all shapes whose box meets this one, in no order.
  void Query(const CAabb2D& box, std::vector<std::uint32_t>& orders);

  /// Has the grid tell of shapes within this reach, user units: before FindNear, ForEachNear and IsClear, in
  /// each substep.
  /// @param least  a grid that was made for less, or for far more than `reach`, is made anew
  void SetReach(float reach, float least);
  /// Whether questions change nothing until SetReach is called or a shape changes, so that threads may ask
  /// at the same time. They do once the grid has lasted for some substeps.
  bool MakeShareable();
  /// The orders of all shapes that come within r of p, and maybe some others, ascending.
  void FindNear(const Vector2& p, float r, std::vector<std::uint32_t>& orders) {
    orders.clear();
    const bool isInGrid = m_cGrid.IsBuilt() && r <= m_cGrid.GetReach();
    if (isInGrid)
      m_cGrid.ForEachNear(p, r, [&orders](std::uint32_t order) {
        orders.push_back(order);
        return true;
      });
    if (!isInGrid || !m_bIsGridComplete) FindOthers(p, r, isInGrid, orders);
  }
  /// Calls f(order) for each of them until it returns false.
  /// @param orders  room to work in
  template <class F>
  void ForEachNear(const Vector2& p, float r, std::vector<std::uint32_t>& orders, const F& f) {
    if (m_bIsGridComplete && r <= m_cGrid.GetReach()) return m_cGrid.ForEachNear(p, r, f);
    FindNear(p, r, orders);
    for (const std::uint32_t order : orders)
      if (!f(order)) return;
  }
  /// Whether surely none of them does: quicker.
  bool IsClear(const Vector2& p, float r) {
    if (m_bIsGridComplete) return m_cGrid.IsClear(p, r);
    if (m_cGrid.IsBuilt() ? !m_cGrid.IsClear(p, r) : !m_cStatic.m_stdOrder.empty()) return false;
    return IsClearOfOthers(p, r);
  }

  /// Makes the geometries of the shapes that rotate in the next dt seconds, and of those that have changed.
  void MakeGeometries(float dt);
  const CShapeGeometry& GetGeometry(std::uint32_t order) const { return m_stdGeometries[order]; }

private:
  /// Items of the tree index m_stdOrder; the last ones may not be in it yet.
  struct CGroup {
    std::vector<std::uint32_t> m_stdOrder;
    std::vector<CAabb2D> m_stdBoxes;
    CAabbTree m_cTree;
    std::size_t m_nGrown = 0; ///< boxes that have grown since the tree was made or refitted

    void BuildTree() {
      m_cTree.Build(m_stdBoxes);
      m_nGrown = 0;
    }
    bool IsTreeComplete() const { return m_cTree.Size() == m_stdBoxes.size(); }
  };
  const CShape& GetShape(std::uint32_t order) const { return *m_stdByOrder[order].m_pShape; }
  static void Query(const CGroup& group, const CAabb2D& box, std::vector<std::uint32_t>& orders);
  void FindOthers(const Vector2& p, float r, bool isInGrid, std::vector<std::uint32_t>& orders);
  void DropGrid();
  void Loosen(std::uint32_t order, const CAabb2D& box);
  /// Whether no grid is to be made: its shapes have not changed.
  bool IsGridLasting() const { return m_cGrid.IsBuilt() && m_stdLoose.empty(); }
  void CountQuestion() {
    if (!IsGridLasting()) ++m_nAsked;
  }
  bool IsClearOfOthers(const Vector2& p, float r) const;

  std::vector<CSolidShape> m_stdByOrder;
  std::vector<std::unique_ptr<CShape>> m_stdRemoved; // that are kept
  CGroup m_cStatic, m_cKinematic;
  bool m_bIsBoxedAtRest = false; // no kinematic shape moved when they were boxed, or was moved since
  // The static shapes once more. It is made once the tree was asked so often since a shape has changed that
  // it pays.
  CShapeGrid m_cGrid;
  // A static shape that has come or changed since the grid was made.
  struct CLoose {
    std::uint32_t m_nOrder;
    CAabb2D m_cBox;
  };
  std::vector<CLoose> m_stdLoose;
  bool m_bIsGridComplete = false; // all shapes are in it
  std::size_t m_nAsked = 0;
  unsigned m_nLasted = 0; // substeps since it was made, or a shape has changed, as far as g_nBeforeSharing
  std::vector<CShapeGeometry> m_stdGeometries; // by order
  std::vector<std::uint32_t> m_stdOld;         // those that are to be made anew
  std::vector<std::uint8_t> m_stdIsOld;        // whether each is among them
};

} // namespace Shapes::Native
