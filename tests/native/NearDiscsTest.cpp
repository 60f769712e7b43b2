// SPDX-License-Identifier: MIT
#include "native/broadphase/NearDiscs.h"

#include "../Testing.h"

namespace Shapes::Native {
namespace {

using CDisc = CNearDiscs::CDisc;

// Each is asked for its list at times, moves by less than the slack, or goes elsewhere.
TEST(NearDiscs, FindEachOnceThatOverlapsNow) {
  constexpr float slack = 0.1f;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    CRandom random(seed);
    // Each has many near it, or a few of a wide range of radii.
    const bool isWide = seed % 4 == 3;
    const std::uint32_t n = isWide ? 2000 : 200;
    const float half = isWide ? 9.0f : 5.0f, least = isWide ? 0.005f : 0.1f;
    CNearDiscs near;
    std::vector<CDisc>& discs = near.GetDiscs();
    for (std::uint32_t i = 0; i < n; ++i)
      discs.push_back({random.InSquare(half), least * std::pow(0.5f / least, random.Uniform(0, 1))});
    std::vector<CDisc> now = discs, last = discs; // and where each went last
    near.Build(slack);
    std::size_t overlaps = 0;
    for (int turn = 0; turn < 4000; ++turn) {
      const std::uint32_t k = random.Below(n);
      if (random.Coin()) {
        const float far = 0.99f * (slack + g_fNearSlack * now[k].m_fRadius);
        now[k].m_vCenter = last[k].m_vCenter + random.VectorOfLength(0.0f, far);
        if (random.Coin()) {
          now[k].m_vCenter = now[random.Below(n)].m_vCenter + random.InSquare(1.0f);
          last[k] = now[k];
        }
        near.Move(k, now[k]);
        continue;
      }
      std::vector<std::uint32_t> found, expected;
      near.Find(k, found);
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "twice";
      EXPECT_FALSE(std::binary_search(found.begin(), found.end(), k)) << "itself";
      for (std::uint32_t j = 0; j < n; ++j)
        if (j != k && now[j].Overlaps(now[k])) expected.push_back(j);
      EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
      overlaps += expected.size();
    }
    EXPECT_GT(overlaps, 2000u) << "nothing was tried";
  }
}

} // namespace
} // namespace Shapes::Native
