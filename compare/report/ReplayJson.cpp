// SPDX-License-Identifier: MIT
// The document for the replay: shapes and trajectories, small enough to be part of a page.
#include "Report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <variant>

namespace Shapes::Compare {
namespace {

using nlohmann::ordered_json;

// Numbers with a fixed number of decimals, because what is drawn needs no more.
class CRounder {
public:
  explicit CRounder(int decimals) : m_fScale(std::pow(10.0, std::abs(decimals))), m_bIsFine(decimals >= 0) {}

  double GetUnit() const { return m_bIsFine ? 1.0 / m_fScale : m_fScale; }

  ordered_json operator()(double x) const {
    if (!std::isfinite(x)) return nullptr;
    // Powers of ten are exact from 1 on: what is divided by one has the shortest text.
    const double rounded =
        m_bIsFine ? std::round(x * m_fScale) / m_fScale : std::round(x / m_fScale) * m_fScale;
    if (rounded == std::trunc(rounded) && std::abs(rounded) < 1e15) return static_cast<std::int64_t>(rounded);
    return rounded;
  }
  ordered_json operator()(float x) const { return (*this)(static_cast<double>(x)); }
  ordered_json operator()(const Vector2& v) const {
    return ordered_json::array({(*this)(v.x()), (*this)(v.y())});
  }

private:
  double m_fScale;
  bool m_bIsFine;
};

// Five digits of the larger side of the scene; and two of the smallest ball, because one looks at it closely.
CRounder MakeRounder(const CScene& scene) {
  const auto digits = [](double x, int n) { return n - 1 - static_cast<int>(std::floor(std::log10(x))); };
  int decimals = digits(std::max(scene.m_cBounds.GetWidth(), scene.m_cBounds.GetHt()), 5);
  for (const CSceneBall& ball : scene.m_stdBalls)
    if (ball.m_cDesc.m_fRadius > 0.0f) decimals = std::max(decimals, digits(ball.m_cDesc.m_fRadius, 2));
  return CRounder(std::clamp(decimals, -30, 30));
}

constexpr int g_nAngleDecimals = 5;

ordered_json ToJson(const CSceneShape& shape, const CRounder& round) {
  const CRounder roundAngle(g_nAngleDecimals);
  ordered_json json = std::visit(
      [&](const auto& desc) -> ordered_json {
        using CDesc = std::decay_t<decltype(desc)>;
        if constexpr (std::is_same_v<CDesc, CLineSegDesc>)
          return {{"type", "segment"},
                  {"points", ordered_json::array({round(desc.GetEndPt0()), round(desc.GetEndPt1())})}};
        else if constexpr (std::is_same_v<CDesc, CPointDesc>)
          return {{"type", "point"}, {"points", ordered_json::array({round(desc.m_vPos)})}};
        else {
          static_assert(std::is_base_of_v<CCircleDesc, CDesc>);
          ordered_json circle{{"type", "circle"},
                              {"points", ordered_json::array({round(desc.m_vPos)})},
                              {"radius", round(desc.m_fRadius)}};
          if constexpr (std::is_same_v<CDesc, CArcDesc>) {
            // The library's arc says what the angles mean: equal ones are the full circle.
            const CArc arc(desc);
            const double a0 = arc.GetAngle0();
            circle["type"] = "arc";
            circle["angles"] =
                ordered_json::array({roundAngle(a0), roundAngle(a0 + static_cast<double>(arc.GetSpan()))});
          }
          return circle;
        }
      },
      shape.m_cDesc);
  json["sensor"] = GetBase(shape.m_cDesc).m_bIsSensor;
  json["turns"] = Turns(shape);
  if (Turns(shape)) json["center"] = round(GetBase(shape.m_cDesc).m_vRotCenter);
  if (Travels(shape)) json["moves"] = true;
  return json;
}

// "start" -> "First trial", "worst native" -> "Worst contact of native".
std::string GetTitle(const std::string& name) {
  constexpr std::string_view worst = "worst ";
  return name.starts_with(worst) ? "Worst contact of " + name.substr(worst.size()) : "First trial";
}

// The tracks of a scene, each once: engines that fly alike share one, in all clips. A coordinate is written
// in units of the last decimal as its second difference from frame to frame, with 0 before the first: a ball
// that flies freely takes a digit or two.
class CTrackPool {
public:
  explicit CTrackPool(double unit) : m_fUnit(unit) {}

  // Where the track is in the list.
  std::size_t Add(const std::vector<Vector2>& track, std::size_t balls) {
    std::vector<CCoordinate> coordinates(2 * balls);
    ordered_json packed = ordered_json::array();
    for (std::size_t i = 0; i < track.size(); ++i)
      for (const Eigen::Index axis : {0, 1})
        packed.push_back(Pack(track[i][axis], coordinates[2 * (i % balls) + static_cast<std::size_t>(axis)]));
    const auto [place, isNew] = m_stdPlaces.try_emplace(packed.dump(), m_cTracks.size());
    if (isNew) m_cTracks.push_back(std::move(packed));
    return place->second;
  }
  const ordered_json& GetTracks() const { return m_cTracks; }

private:
  struct CCoordinate {
    std::int64_t m_nLast = 0, m_nStep = 0;
  };
  // Beyond any picture, and still exact where the page adds up.
  static constexpr double g_fFarthest = 1e12;

  ordered_json Pack(float x, CCoordinate& before) const {
    const double units = std::round(static_cast<double>(x) / m_fUnit);
    if (!(std::abs(units) < g_fFarthest)) return nullptr;
    const std::int64_t step = static_cast<std::int64_t>(units) - before.m_nLast, turn = step - before.m_nStep;
    before = {static_cast<std::int64_t>(units), step};
    return turn;
  }

  double m_fUnit;
  std::map<std::string, std::size_t> m_stdPlaces;
  ordered_json m_cTracks = ordered_json::array();
};

ordered_json ToJson(const CClip& clip, const CScene& scene, const CRounder& round, CTrackPool& pool) {
  const std::size_t frames = clip.GetFrames(scene.m_stdBalls.size());
  ordered_json json{{"name", clip.m_sName},
                    {"title", GetTitle(clip.m_sName)},
                    {"what", clip.m_sWhat},
                    {"contact", clip.m_nContact},
                    {"ball", clip.m_nBall},
                    {"time", clip.m_fTime},
                    {"frames", frames},
                    {"tracks", ordered_json::array()},
                    {"orientations", ordered_json::array()},
                    {"offsets", ordered_json::array()}};
  for (const std::vector<Vector2>& track : clip.m_stdTracks)
    json["tracks"].push_back(pool.Add(track, scene.m_stdBalls.size()));
  const CRounder roundAngle(g_nAngleDecimals);
  const double dt = scene.m_cWorld.m_fTimeStep;
  for (const CSceneShape& shape : scene.m_stdShapes) {
    if (!Turns(shape)) continue;
    ordered_json angles = ordered_json::array();
    for (std::size_t i = 0; i < frames; ++i)
      angles.push_back(roundAngle(OrientationAt(shape, clip.m_fTime + static_cast<double>(i) * dt)));
    json["orientations"].push_back(std::move(angles));
  }
  for (const CSceneShape& shape : scene.m_stdShapes) {
    if (!Travels(shape)) continue;
    ordered_json ways = ordered_json::array();
    for (std::size_t i = 0; i < frames; ++i) {
      const Eigen::Vector2d way = OffsetAt(shape, clip.m_fTime + static_cast<double>(i) * dt);
      ways.push_back(round(static_cast<float>(way.x())));
      ways.push_back(round(static_cast<float>(way.y())));
    }
    json["offsets"].push_back(std::move(ways));
  }
  return json;
}

ordered_json ToJson(const CSceneReport& report) {
  const CScene& scene = report.m_cScene;
  const CRounder round = MakeRounder(scene);
  const CAabb2D& bounds = scene.m_cBounds;
  ordered_json json{{"name", scene.m_sName},
                    {"time_step", scene.m_cWorld.m_fTimeStep},
                    {"bounds",
                     {{"left", round(bounds.GetTopLeft().x())},
                      {"bottom", round(bounds.GetBottomRt().y())},
                      {"right", round(bounds.GetBottomRt().x())},
                      {"top", round(bounds.GetTopLeft().y())}}},
                    {"radii", ordered_json::array()},
                    {"shapes", ordered_json::array()},
                    {"clips", ordered_json::array()},
                    {"unit", round.GetUnit()}};
  for (const CSceneBall& ball : scene.m_stdBalls)
    json["radii"].push_back(ball.m_cDesc.m_fRadius);
  for (const CSceneShape& shape : scene.m_stdShapes)
    json["shapes"].push_back(ToJson(shape, round));
  CTrackPool pool(round.GetUnit());
  for (const CClip& clip : report.m_stdClips)
    json["clips"].push_back(ToJson(clip, scene, round, pool));
  json["tracks"] = pool.GetTracks();
  return json;
}

} // namespace

std::string MakeReplayJson(const CRunReport& report) {
  ordered_json json{{"engines", ordered_json::array()}, {"scenes", ordered_json::array()}};
  for (const CEngine& engine : report.m_stdEngines)
    json["engines"].push_back(engine.m_sName);
  json["engines"].push_back(g_sExact);
  for (const CSceneReport& scene : report.m_stdScenes)
    json["scenes"].push_back(ToJson(scene));
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace Shapes::Compare
