// SPDX-License-Identifier: MIT
// A scene that a program holds, written as a file for the tool and read by it.
#include "MadeScenes.h"

#include <bit>
#include <filesystem>
#include <fstream>

#include "../Random.h"

namespace Shapes::Compare {
namespace {

class SceneDescTest : public testing::Test {
protected:
  SceneDescTest()
      : m_cFile(std::filesystem::path(testing::TempDir()) /
                (std::string("shapes-desc-") + testing::UnitTest::GetInstance()->current_test_info()->name() +
                 ".json")) {}
  ~SceneDescTest() override { std::filesystem::remove(m_cFile); }

  CScene WriteAndLoad(const CSceneDesc& desc) const {
    std::ofstream(m_cFile, std::ios::binary) << desc.ToJson("imported", 0.5f);
    return LoadScene(m_cFile);
  }

  static CSceneDesc OneOfEach() {
    CSceneDesc desc;
    desc.m_cWorld.m_vGravity = {0.1f, -9.81f};
    desc.m_cWorld.m_cBox2D.m_fLengthUnit = 1.1f;
    desc.m_stdNotes = {"A note with \"quotes\", \\ and \t."};
    CLineSegDesc seg({-3, 0}, {3, 0.1f}, 0.7f);
    seg.m_eSides = eSides::Front;
    CCircleDesc circle({0.3f, 1}, 0.2f);
    circle.m_eMotionType = eMotion::Kinematic;
    circle.m_fRotSpeed = -0.3f;
    circle.m_vRotCenter = {0.1f, 0.9f};
    CArcDesc arc({0, 1}, 3, 0.1f, 3.1f);
    arc.m_bIsSensor = true;
    arc.m_cFilter = {2, 7};
    desc.m_stdShapes = {CPointDesc({0.1f, 0.2f}, 0.3f), seg, circle, arc, CArcDesc({0, 0}, 9, 1, 1)};
    desc.m_stdBalls = {CDynamicCircleDesc({0.1f, 2}, 0.1f, {0.3f, 0.7f}, 1.3f, 0.9f)};
    desc.m_stdBalls[0].m_cFilter = {0x8000, 0xFFFF};
    return desc;
  }

  std::filesystem::path m_cFile;
};

// The text of the same scene has the same floats, so equal texts are equal bits.
TEST_F(SceneDescTest, TheLoaderReadsWhatWasWrittenBitForBit) {
  const CSceneDesc desc = OneOfEach();
  const CScene scene = WriteAndLoad(desc);
  EXPECT_EQ(Tests::ToDesc(scene).ToJson("imported", scene.m_fDuration), desc.ToJson("imported", 0.5f));
}

TEST_F(SceneDescTest, EveryFloatSurvives) {
  Shapes::Tests::CRandom random(5);
  for (int n = 0; n < 20; ++n) {
    CSceneDesc desc;
    desc.m_stdBalls = {CDynamicCircleDesc({0, 0}, 1)};
    for (int i = 0; i < 500; ++i) {
      const Vector2 p = random.Vector(-60, 50);
      desc.m_stdShapes.emplace_back(CPointDesc(p, random.Scale(-40, 18)));
    }
    const std::vector<CAnyShapeDesc> loaded = GetShapes(WriteAndLoad(desc));
    ASSERT_EQ(loaded.size(), desc.m_stdShapes.size());
    for (std::size_t i = 0; i < loaded.size(); ++i) {
      const auto &a = std::get<CPointDesc>(desc.m_stdShapes[i]), &b = std::get<CPointDesc>(loaded[i]);
      ASSERT_TRUE(a.m_vPos == b.m_vPos && a.m_fElasticity == b.m_fElasticity)
          << "seed " << random.GetSeed() << ": " << a.m_vPos.transpose() << ", " << a.m_fElasticity;
    }
  }
}

// Mechanism: the reader rounds the text to double and that to float. The double nearest to 7.038531e-26, the
// shortest text of this float, lies exactly between it and the next one. A search through all floats found no
// other.
TEST_F(SceneDescTest, TheOneFloatSurvivesThatRoundingTwiceChanges) {
  const auto value = std::bit_cast<float>(0x15AE43FDu);
  EXPECT_NE(static_cast<float>(7.038531e-26), value); // the control: double first
  CSceneDesc desc;
  desc.m_stdBalls = {CDynamicCircleDesc({value, -value}, 1)};
  EXPECT_EQ(WriteAndLoad(desc).m_stdBalls.at(0).m_cDesc.m_vPos, Vector2(value, -value));
}

} // namespace
} // namespace Shapes::Compare
