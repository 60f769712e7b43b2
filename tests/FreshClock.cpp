// SPDX-License-Identifier: MIT
// Tests share a process, and the gravity and the time step of CShape::move are static: each test begins with
// the defaults, whatever the one before it has set.
#include <Shapes/Shape.h>

#include <gtest/gtest.h>

namespace Shapes {
namespace {

class CFreshClock : public testing::EmptyTestEventListener, CShapeCommon {
  void OnTestStart(const testing::TestInfo&) override {
    m_fGravity = 0.0f;
    m_fTimeStep = 1.0f / 60.0f;
  }
};

[[maybe_unused]] const bool g_bIsInstalled = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new CFreshClock); // GoogleTest deletes it
  return true;
}();

// The control: whichever of these runs first, the other one would see its clock.
struct CSpoiledClock : CShapeCommon {
  static void Expect() {
    EXPECT_EQ(m_fGravity, 0.0f);
    EXPECT_EQ(m_fTimeStep, 1.0f / 60.0f);
    m_fGravity = -1.0f;
    m_fTimeStep = 1.0f;
  }
};
TEST(FreshClockTest, OneTestSpoilsIt) { CSpoiledClock::Expect(); }
TEST(FreshClockTest, AndTheOtherDoesNotNotice) { CSpoiledClock::Expect(); }

} // namespace
} // namespace Shapes
