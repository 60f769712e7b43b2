// SPDX-License-Identifier: MIT
#include "app/Options.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace Shapes::Compare {
namespace {

std::vector<std::string> Selected(const std::vector<std::string>& names) {
  std::vector<std::string> selected;
  for (const CEngine& engine : SelectEngines(GetEngines(), names))
    selected.push_back(engine.m_sName);
  return selected;
}

TEST(OptionsTest, EnginesComeInTheirOrderWhateverIsAsked) {
  using CNames = std::vector<std::string>;
  EXPECT_EQ(Selected({}), (CNames{"native", "native-approximate", "box2d", "box2d-tuned"}));
  EXPECT_EQ(Selected({"box2d", "native"}), (CNames{"native", "box2d"}));
  EXPECT_EQ(Selected({"box2d", "box2d"}), (CNames{"box2d"}));
  EXPECT_EQ(Selected({"native"}), (CNames{"native"}));
}

TEST(OptionsTest, UnknownNamesAreRefused) {
  EXPECT_THROW(Selected({"native", "boxtd"}), std::invalid_argument);
  EXPECT_THROW(Selected({""}), std::invalid_argument);
  CScene scene;
  scene.m_sName = "bowl";
  const std::vector<std::string> known{"bowl"}, unknown{"bowls"};
  EXPECT_EQ(SelectScenes({scene}, known).size(), 1u);
  EXPECT_THROW(SelectScenes({scene}, unknown), std::invalid_argument);
}

TEST(OptionsTest, CommandsAreQuotedForAShell) {
  EXPECT_EQ(JoinCommand(std::vector<std::string>{"a", "--out=b/c", "x,y"}), "a --out=b/c x,y");
  EXPECT_EQ(JoinCommand(std::vector<std::string>{"a b", "", "it's", "$x"}), "'a b' '' 'it'\\''s' '$x'");
}

} // namespace
} // namespace Shapes::Compare
