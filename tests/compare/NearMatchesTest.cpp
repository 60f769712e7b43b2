// SPDX-License-Identifier: MIT
#include "app/NearMatches.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "Random.h"

namespace Shapes::Compare {
namespace {

TEST(NearMatchesTest, DistancesCountEdits) {
  EXPECT_EQ(EditDistance("", ""), 0u);
  EXPECT_EQ(EditDistance("", "abc"), 3u);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(EditDistance("pinbal", "pinball"), 1u);
  EXPECT_EQ(EditDistance("pniball", "pinball"), 1u); // two letters swapped
  EXPECT_EQ(EditDistance("ca", "abc"), 3u);          // restricted: what was swapped is not changed again
}

// Against the definition, without the table.
std::size_t Slow(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string_view a1 = a.substr(1), b1 = b.substr(1);
  std::size_t least = std::min({Slow(a1, b) + 1, Slow(a, b1) + 1, Slow(a1, b1) + (a[0] == b[0] ? 0 : 1)});
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
    least = std::min(least, Slow(a.substr(2), b.substr(2)) + 1);
  return least;
}

TEST(NearMatchesTest, DistancesAreThoseOfTheDefinition) {
  Shapes::Tests::CRandom random(3);
  const auto word = [&] {
    std::string text(random.Below(6), ' ');
    for (char& c : text)
      c = static_cast<char>('a' + random.Below(3));
    return text;
  };
  for (int i = 0; i < 500; ++i) {
    const std::string a = word(), b = word();
    EXPECT_EQ(EditDistance(a, b), Slow(a, b)) << a << " " << b << ", seed " << random.GetSeed();
    EXPECT_EQ(EditDistance(a, b), EditDistance(b, a)) << a << " " << b << ", seed " << random.GetSeed();
  }
}

TEST(NearMatchesTest, NearestFirstAndNoStrangers) {
  const std::vector<std::string> known{"open_arc_outside", "open_arc_inside", "pinball", "bowl"};
  EXPECT_EQ(NearMatches("open_arc_insid", known),
            (std::vector<std::string>{"open_arc_inside", "open_arc_outside"}));
  EXPECT_EQ(NearMatches("PINBALL", known), (std::vector<std::string>{"pinball"}));
  EXPECT_EQ(NearMatches("bow", known), (std::vector<std::string>{"bowl"}));
  EXPECT_TRUE(NearMatches("spinner", known).empty());
  EXPECT_TRUE(NearMatches("", known).empty());
}

TEST(NearMatchesTest, TheMessageNamesThem) {
  const std::vector<std::string> known{"native", "box2d"};
  EXPECT_EQ(UnknownName("engine", "box2", known),
            "there is no engine 'box2': did you mean 'box2d'? Known: native, box2d");
  EXPECT_EQ(UnknownName("engine", "jolt", known), "there is no engine 'jolt'. Known: native, box2d");
}

} // namespace
} // namespace Shapes::Compare
