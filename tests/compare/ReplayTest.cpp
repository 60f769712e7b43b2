// SPDX-License-Identifier: MIT
#include "report/Replay.h"
#include "MadeScenes.h"

namespace Shapes::Compare {
namespace {

struct CReplay {
  CScene m_cScene;
  CImpactTrialResult m_cImpactTrials;
  std::vector<CClip> m_stdClips;
};

CReplay Make(const std::string& name) {
  CReplay replay;
  replay.m_cScene = Tests::LoadBundled(name);
  replay.m_cImpactTrials = Tests::Judge(replay.m_cScene, 200, 4000);
  replay.m_stdClips = MakeClips(replay.m_cScene, GetEngines(), replay.m_cImpactTrials, 5, 120);
  return replay;
}

Vector2 At(const CClip& clip, std::size_t track, std::size_t frame, std::size_t balls) {
  return clip.m_stdTracks[track][frame * balls + clip.m_nBall];
}

TEST(Replay, AllTracksStartTogetherAndHaveTheSameLength) {
  for (const char* name : {"pinball", "ball_on_ball", "spinner"}) {
    SCOPED_TRACE(name);
    const CReplay replay = Make(name);
    const std::size_t balls = replay.m_cScene.m_stdBalls.size();
    ASSERT_EQ(replay.m_stdClips.size(), 1 + GetEngineRows().size());
    EXPECT_EQ(replay.m_stdClips[0].m_sName, "start");
    for (std::size_t e = 0; e < GetEngineRows().size(); ++e)
      EXPECT_EQ(replay.m_stdClips[e + 1].m_sName, std::string("worst ") + GetEngineRows()[e].m_sName);
    for (const CClip& clip : replay.m_stdClips) {
      ASSERT_EQ(clip.m_stdTracks.size(), GetEngineRows().size() + 1);
      for (const auto& track : clip.m_stdTracks) {
        EXPECT_EQ(track.size(), clip.m_stdTracks[0].size());
        EXPECT_TRUE(std::equal(track.begin(), track.begin() + static_cast<std::ptrdiff_t>(balls),
                               clip.m_stdTracks[0].begin()));
      }
      EXPECT_LT(clip.m_nContact, clip.GetFrames(balls));
    }
  }
}

TEST(Replay, TheWorstContactOfNativeAtAWallIsWhereItTunnels) {
  const CReplay replay = Make("head_on_wall");
  const CClip& clip = replay.m_stdClips.at(1 + Tests::g_nApproximate);
  const std::size_t exact = clip.m_stdTracks.size() - 1;
  EXPECT_NE(clip.m_sWhat.find("native-approximate"), std::string::npos);
  ASSERT_GT(clip.m_nContact, 0u);
  // Up to the frame before, all fly alike; at the contact the exact ball has turned back, and some steps
  // later native's is on the other side of the wall, which is at x = 0.
  const std::size_t k = clip.m_nContact, late = clip.GetFrames(1) - 1;
  EXPECT_LT((At(clip, Tests::g_nApproximate, k - 1, 1) - At(clip, exact, k - 1, 1)).norm(), 1e-5f);
  EXPECT_GT(At(clip, exact, k - 1, 1).x(), At(clip, exact, late, 1).x()); // turned back
  EXPECT_LT(At(clip, exact, late, 1).x(), 0.0f);
  EXPECT_GT(At(clip, Tests::g_nApproximate, late, 1).x(), 0.0f);
}

} // namespace
} // namespace Shapes::Compare
