// SPDX-License-Identifier: MIT
// The result of a scene to the last bit, in one number: the same for every compiler and every build type.
// A change that alters a result on purpose puts the lines here that the tests print. docs/testing.md says
// more.
#include "Played.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>

#ifdef SHAPES_GOLDEN_TRAPS
#include <cfenv>
#endif

namespace Shapes::Tests {
namespace {

using namespace Compare;

constexpr int g_nSteps = 600;

struct CGolden {
  const char* m_sScene;
  std::uint64_t m_nApproximate, m_nContinuous;
};

constexpr CGolden g_stdGolden[] = {
    {"ball_on_ball", 0xD913E710D1DCC096u, 0xB744C463BD0BDB16u},
    {"bowl", 0xE080EFA1E202A5ACu, 0xD5CD72C961EDFCF3u},
    {"corner", 0xE9BD87B65A11D820u, 0x7DE323C242CD4F7Du},
    {"disc_in_square", 0x68480CF3FB8259ACu, 0x851C0BB51344BD0Bu},
    {"elastic_drop", 0x8AADBD4EA7F4C98Eu, 0xF6922E390ED06B10u},
    {"grazing_wall", 0x5F457A6652A7DF8Du, 0xE630CB39DB41E36Du},
    {"guarded_ends", 0xF53901E7EF0291A7u, 0x902428F280880812u},
    {"head_on_wall", 0x39ABA93BA7B69B39u, 0xBAAB3BD25A184343u},
    {"naked_ends", 0x9CAD17C9E53BCF61u, 0xD58DFBD198CC696Eu},
    {"open_arc_inside", 0x64EC58454D46B18Cu, 0x23681290D7246F88u},
    {"open_arc_outside", 0x48A06C3E901AF299u, 0x8E4331ECDF797DD1u},
    {"pinball", 0x2A25F4534457EE76u, 0x8BA5BE39BA1A55C4u},
    {"point_off_centre", 0x124388FF97AE8863u, 0xD847742D4786AF3Au},
    {"spinner", 0x56A3D35EEA79E444u, 0x409998423EA23948u},
    {"tangent_joint", 0xB399D01D85470B63u, 0x1160B11FC7451883u},
    {"bowl_of_20", 0xC9EC1B772EF33CF7u, 0xE7F387A8144A86D1u},
    {"chute", 0xF8F097A85DA174D3u, 0x1085A7790ABE18C7u},
    {"closing_gates", 0x1B69CFF54B924AB3u, 0x432E0A5FF5B202EAu},
    {"cylinder", 0x4F1EE658A6A13D88u, 0xF2EB394EC4B414FBu},
    {"funnel", 0x97B9566222A9400Cu, 0x367CA65F85A8A7F6u},
    {"hourglass", 0xB242CD4FD0543707u, 0xD5224B1B3F9BD52Bu},
    {"paddle", 0x105A2B9B13DC5A79u, 0xF577B63767CCD6D8u},
    {"pile_of_50", 0x739A824FF41E276Du, 0x5F40BF46408301D7u},
    {"box_of_balls", 0x767C10CCB7C4E0A9u, 0x0498FC6E9D04C0E5u},
};

CScene Find(const std::string& name) { return name == "box_of_balls" ? MakeBoxOfBalls() : LoadBundled(name); }

std::uint64_t Play(const CScene& scene, const CEffectChoice& effects) {
#ifdef SHAPES_GOLDEN_TRAPS
  std::feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
  CPlayed played(scene, effects);
  CHash hash;
  for (int i = 0; i < g_nSteps; ++i) {
    played.Step();
    AddTo(hash, played.GetWorld());
  }
#ifdef SHAPES_GOLDEN_TRAPS
  fedisableexcept(FE_ALL_EXCEPT);
#endif
  return hash.Get();
}

class GoldenTest : public testing::TestWithParam<CGolden> {};

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenTest, testing::ValuesIn(g_stdGolden),
                         [](const auto& golden) { return golden.param.m_sScene; });

TEST_P(GoldenTest, EveryBitIsTheSame) {
  const CGolden& golden = GetParam();
  const CScene scene = Find(golden.m_sScene);
  const std::uint64_t approximate = Play(scene, g_cApproximate), continuous = Play(scene, g_cContinuous);
  std::array<char, 120> line;
  std::snprintf(line.data(), line.size(), "    {\"%s\", 0x%016" PRIX64 "u, 0x%016" PRIX64 "u},",
                golden.m_sScene, approximate, continuous);
  EXPECT_TRUE(approximate == golden.m_nApproximate && continuous == golden.m_nContinuous)
      << line.data() << " is what came out";
}

TEST(GoldenHashTest, EverySceneHasItsHashes) {
  for (const CScene& scene : LoadScenes(SHAPES_SCENES_DIR))
    EXPECT_TRUE(std::ranges::count(g_stdGolden, scene.m_sName, &CGolden::m_sScene)) << scene.m_sName;
}

// The controls: other bits, or bits in another order, give another number.
TEST(GoldenHashTest, OneBitAndTheOrderOfAdditionsAreSeen) {
  const auto hashOf = [](float f) {
    CHash hash;
    hash.Add(f);
    return hash.Get();
  };
  const volatile float a = 1e8f, b = -1e8f, c = 1.0f;
  EXPECT_NE(hashOf((a + b) + c), hashOf(a + (b + c)));
  EXPECT_NE(hashOf(a), hashOf(std::nextafter(a, b)));
  EXPECT_NE(hashOf(0.0f), hashOf(-0.0f));
  CHash abcd;
  abcd.Add(std::uint32_t{0x64636261});
  EXPECT_EQ(abcd.Get(), 0xFC179F83EE0724DDu); // of the bytes "abcd"
}

} // namespace
} // namespace Shapes::Tests
