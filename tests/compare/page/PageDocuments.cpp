// SPDX-License-Identifier: MIT
#include "PageDocuments.h"

#include "metrics/Figures.h"
#include "report/Chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

namespace Shapes::Compare {
namespace {

using nlohmann::json;

constexpr std::size_t g_nBins = 32;

// Figures that differ from scene to scene; what they are does not matter.
class CNumbers {
public:
  explicit CNumbers(std::uint64_t seed) : m_nState(seed * 0x9E3779B97F4A7C15u + 1) {}

  /// From [low, high).
  double operator()(double low, double high) {
    m_nState = m_nState * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * static_cast<double>(m_nState >> 40) / 16777216.0;
  }

private:
  std::uint64_t m_nState;
};

json Summary(double median, int count = 19000) {
  if (count == 0) return {{"count", 0}, {"median", nullptr}, {"p95", nullptr}, {"max", nullptr}};
  return {
      {"count", count}, {"median", median}, {"p95", 3.1 * std::abs(median)}, {"max", 9 * std::abs(median)}};
}

json Rate(int count, int n) {
  if (n == 0) return {{"count", 0}, {"rate", nullptr}, {"low", 0}, {"high", 1}};
  const double p = double(count) / n, s = 2 * std::sqrt((p * (1 - p) + 1.0 / n) / n);
  return {{"count", count}, {"rate", p}, {"low", std::max(0.0, p - s)}, {"high", std::min(1.0, p + s)}};
}

json Histogram(double scale, int n) {
  json counts = json::array();
  for (std::size_t i = 0; i < g_nBins; ++i)
    counts.push_back(int(n * std::exp(-25 * std::pow(double(i) / scale - 1, 2)) / (scale * 0.35)));
  return counts;
}

json Bins(CNumbers& figures, double lost) {
  json bins = json::array();
  const auto add = [&](const char* pBy, const char* pLabel, double factor) {
    const int n = int(figures(500, 9000));
    bins.push_back({{"by", pBy},
                    {"label", pLabel},
                    {"contacts", n},
                    {"tunneled", Rate(int(n * lost * factor), n)},
                    {"setback_error", Summary(0.1 * factor + 0.01)},
                    {"direction_error", Summary(0.02 * factor + 1e-6)}});
  };
  add("travel", "< 0.5 radii", 0);
  add("travel", "0.5 - 1 radii", 0.3);
  add("travel", "1 - 2 radii", 2);
  add("incidence", "0 - 30 degrees", 0.6);
  add("incidence", "30 - 60 degrees", 1);
  add("incidence", "60 - 90 degrees", 1.7);
  add("pair", "segment", 0.5);
  add("pair", "segment end", 2.4);
  add("elasticity", "< 1", 1);
  return bins;
}

json Engine(const std::string& name, CNumbers& figures, int n) {
  const bool isNative = name.starts_with("native"), isTuned = name == "box2d-tuned";
  const double lost =
      name == "native-approximate" ? std::pow(figures(0, 0.6), 3) : std::max(0.0, figures(-0.003, 0.004));
  const int missed = int(n * lost * 0.4), wrong = int(n * lost * 0.6), late = isNative ? 0 : int(n * 0.002);
  const double error = isNative ? figures(0.05, 0.5) : figures(0.01, 0.1);
  const double ns = isNative ? figures(35, 220) : figures(400, 2100) * (isTuned ? 1.5 : 1.0);
  json settings{{"time_step", 1.0 / 60}, {"substeps", 1}};
  if (!isNative) settings["profile"] = isTuned ? "tuned" : "shipped";
  return {{"name", name},
          {"settings", std::move(settings)},
          {"features", {"gravity", "ball_pairs"}},
          {"grade", lost > 0.01    ? "poor"
                    : lost > 0.001 ? "rough"
                                   : "good"},
          {"contacts", n},
          {"correct", n - missed - wrong - late},
          {"late", Rate(late, n)},
          {"missed", Rate(missed, n)},
          {"wrong_side", Rate(wrong, n)},
          {"tunneled", Rate(missed + wrong, n)},
          {"overlapped", Rate(isNative ? 0 : n / 40, n)},
          {"ghost", Rate(isNative ? 0 : 3, 54321)},
          {"setback", Summary(error * 2)},
          {"setback_error", Summary(error, isNative ? 9158 : n)},
          {"setback_error_normal", Summary(-error / 5)},
          {"time_error", Summary(error / 9)},
          {"poi_error", Summary(error / 2)},
          {"normal_error", Summary(error / 30)},
          {"direction_error", Summary(isNative ? error / 10 : 1e-8)},
          {"speed_error", Summary(1.2e-7)},
          {"energy_error", Summary(-3.4e-5)},
          {"position_error", Summary(error / 3)},
          {"penetration", Summary(isNative ? 0 : 0.004)},
          {"setback_error_histogram", Histogram(isNative ? 22 : 18, n)},
          {"penetration_histogram", Histogram(isNative ? 5 : 17, n)},
          {"bins", Bins(figures, lost)},
          {"bounces", 100000},
          {"energy_drift", isNative ? json(-0.0012) : json(6.5)},
          {"free_path_error", 0.002},
          {"angular_momentum_drift", nullptr},
          {"ns_per_ball_step", ns},
          {"ns_per_ball_step_interval", {ns * 0.97, ns * 1.04}},
          {"ns_per_contact", ns * 11},
          {"simulated_seconds", 833.3},
          {"escaped", 2},
          {"not_finite", 0}};
}

json HeatMap(CNumbers& figures) {
  const std::vector<double> speeds{0.25, 0.5, 1, 2, 4, 8}, sizes{0.25, 0.5, 1, 2};
  const double travel = figures(0.4, 2.5);
  json map{{"speeds", speeds}, {"sizes", sizes}, {"travel", travel}, {"cells", json::array()}};
  for (const double size : sizes)
    for (const double speed : speeds) {
      const double way = travel * speed / size;
      const int n = size == 2 && speed == 0.25 ? 0 : 2000;
      map["cells"].push_back(
          {{"contacts", n},
           {"tunneled", {0, int(n * std::max(0.0, 1 - 1 / way)), 0, int(map["cells"].size()) * n / 23, 0}}});
    }
  return map;
}

json WorkRow(const std::string& scene, const std::string& engine, const std::string& label, json settings,
             double ns, double error, double lost) {
  const int n = 5000;
  return {{"scene", scene},
          {"engine", engine},
          {"label", label},
          {"settings", std::move(settings)},
          {"ns_per_ball_second", ns},
          {"ns_per_ball_second_interval", {ns * 0.96, ns * 1.05}},
          {"direction_error_p95", error},
          {"contacts", n},
          {"miss_rate", Rate(int(n * lost / 2), n)},
          {"tunneled_rate", Rate(int(n * lost), n)},
          {"proof", label == "8 substeps" ? json{{"contacts", 95000}, {"tunneled", 0}} : json(nullptr)}};
}

// Whether nothing in `rows` is both cheaper and better.
bool IsOnFront(const json& rows, const json& row, const std::function<double(const json&)>& badness) {
  const auto cost = [](const json& r) { return r["ns_per_ball_second"].get<double>(); };
  return std::none_of(rows.begin(), rows.end(), [&](const json& other) {
    return (cost(other) < cost(row) && badness(other) <= badness(row)) ||
           (cost(other) <= cost(row) && badness(other) < badness(row));
  });
}

json Work(const std::string& scene, CNumbers& figures) {
  json rows = json::array();
  const double base = figures(2000, 9000), error = figures(0.02, 0.6), lost = figures(0.001, 0.5);
  for (const int steps : {1, 2, 4, 8, 16})
    rows.push_back(WorkRow(scene, "native-approximate",
                           steps == 1 ? "as it comes" : std::to_string(steps) + " substeps",
                           {{"time_step", 1.0 / 60}, {"substeps", steps}}, base * (0.3 + 0.7 * steps),
                           error / steps, steps > 4 ? 0 : lost / steps / steps));
  for (const int steps : {1, 2, 4, 8})
    rows.push_back(WorkRow(scene, "native", steps == 1 ? "as it comes" : std::to_string(steps) + " substeps",
                           {{"time_step", 1.0 / 60}, {"substeps", steps}}, base * (0.4 + 0.9 * steps),
                           error / steps / 4, 0));
  const std::array<const char*, 5> labels{"as it comes", "2 substeps", "4 substeps", "20 velocity iterations",
                                          "2 substeps, 10 units to a metre"};
  for (std::size_t i = 0; i < labels.size(); ++i)
    rows.push_back(WorkRow(scene, "box2d", labels[i], {{"time_step", 1.0 / 60}, {"substeps", 1}},
                           base * figures(8, 40), error * figures(0.005, 0.1), i == 1 ? 0.002 : 0.0));
  for (const char* pLabel : {"as it comes", "2 substeps", "arcs 4x finer"})
    rows.push_back(WorkRow(scene, "box2d-tuned", pLabel,
                           {{"time_step", 1.0 / 60}, {"substeps", 1}, {"profile", "tuned"}},
                           base * figures(20, 60), error * figures(1e-5, 1e-3), 0.0));
  json judged = rows;
  for (json& row : judged) {
    row["front_by_error"] =
        IsOnFront(rows, row, [](const json& r) { return r["direction_error_p95"].get<double>(); });
    row["front_by_misses"] =
        IsOnFront(rows, row, [](const json& r) { return r["tunneled_rate"]["rate"].get<double>(); });
  }
  judged.push_back(WorkRow(scene, "exact", "exact", json::object(), base * 60, 0, 0));
  judged.back()["front_by_error"] = judged.back()["front_by_misses"] = false;
  return judged;
}

json EffectWorld(double ns, double instructions, int lost, double flight) {
  return {{"ns_per_ball_step", ns},
          {"ns_per_ball_step_interval", {0.98 * ns, 1.03 * ns}},
          {"instructions_per_ball_step", instructions},
          {"contacts", 500},
          {"tunneled", Rate(lost, 500)},
          {"direction_error", Summary(0.02, 480)},
          {"speed_error", Summary(0.003, 480)},
          {"flight_error", Summary(flight, 100)},
          {"touches_missed", Rate(0, 0)}};
}

json EffectRow(const char* pScene, const char* pEngine, const char* pEffect, double runs, double ratio) {
  const bool isLost = runs > 0 && std::string(pEffect) == "continuous";
  return {{"scene", pScene},
          {"engine", pEngine},
          {"effect", pEffect},
          {"runs", runs},
          {"why", "the fastest ball moves 2 radii a substep, </script><b>1 < 2</b>"},
          {"ns_ratio", ratio},
          {"ns_ratio_interval", {ratio - 0.02, ratio + 0.03}},
          {"with", EffectWorld(100 * ratio, 800 * ratio, 0, 0.01)},
          {"without", EffectWorld(100, 800, isLost ? 250 : 0, runs > 0 ? 20 : 0.01)}};
}

// Of two engines, each with all effects: one of each kind.
void AddEffects(const std::string& scene, json& rows) {
  for (const char* pEngine : {"native", "box2d"}) {
    rows.push_back(EffectRow(scene.c_str(), pEngine, "gravity", 1, 1.15));
    rows.push_back(EffectRow(scene.c_str(), pEngine, "kinematics", 0.35, 5.5));
    rows.push_back(EffectRow(scene.c_str(), pEngine, "ball_pairs", 0, 1.4));
    rows.push_back(EffectRow(scene.c_str(), pEngine, "sensors", 0, 1.01));
    rows.push_back(EffectRow(scene.c_str(), pEngine, "events", 1, 0.9));
    rows.push_back(EffectRow(scene.c_str(), pEngine, "continuous", 1, 1.3));
  }
}

// A demand that the first of some engines meets for the least time.
json Answer(const char* pDemand, const std::vector<std::string>& engines) {
  json choices = json::array();
  for (const std::string& engine : engines) {
    const double times = double(choices.size()) + 1;
    choices.push_back({{"engine", engine},
                       {"label", engine == "box2d" ? "32 substeps, 10x scale, arcs 16x finer, 1+1 iterations"
                                                   : "as it comes"},
                       {"ns_per_ball_second", 5600.0 * times},
                       {"ns_ratio", times}});
  }
  json closest;
  if (engines.empty())
    closest = {{"engine", "box2d"},
               {"label", "4 substeps"},
               {"direction_error_p95", 0.0123},
               {"tunneled", Rate(3, 5000)}};
  return {
      {"demand", pDemand}, {"choices", choices}, {"without", {"native-approximate"}}, {"closest", closest}};
}

json Scene(const std::string& name, CNumbers& figures) {
  const int n = 20000;
  json engines = json::array();
  for (const CEngineRow& row : GetEngineRows())
    engines.push_back(Engine(row.m_sName, figures, n));
  return {
      {"name", name},
      {"description",
       "Made up: two balls in a box with a bar that turns, </script><b>1 < 2</b> & \"quotes\"."},
      {"length_unit", 1},
      {"time_step", 1.0 / 60},
      {"gravity", {0, -10}},
      {"duration", 10},
      {"features", {"gravity", "kinematics", "ball_pairs"}},
      {"shapes", 9},
      {"balls", 2},
      {"trials", 1234},
      {"quiet_steps", 54321},
      {"set_aside",
       {{"resting", 12},
        {"ambiguous", 3},
        {"simultaneous", 0},
        {"undecided", 0},
        {"first_undecided", nullptr}}},
      {"apart", Summary(0.2)},
      {"take", "native"},
      {"verdict",
       {"Use native: as good as Box2D here and 11 times faster; native-approximate is 1.9 times faster but "
        "loses 1 in 40.",
        "It loses none of 20,000, and 95% of its bounces are within 0.02 degrees; Box2D loses none of "
        "20,000."}},
      {"remarks", {"Turned back one or two steps late: native 0.50%, box2d 30.0%."}},
      {"answers",
       {Answer("Bounces within 0.6 degrees (.01 rad), fewer than 1 in 100 lost", {"native", "box2d"}),
        Answer("Bounces within 0.06 degrees (.001 rad), fewer than 1 in 1,000 lost", {}),
        Answer("None lost in 100,000 impacts", {"native", "box2d", "box2d-tuned"})}},
      {"engines", std::move(engines)},
      {"heat_map", HeatMap(figures)},
      {"sensor_touches", 0},
      {"not_counted", nullptr}};
}

json Shapes() {
  return {
      {{"type", "segment"}, {"points", {{-2, -1}, {2, -1}}}, {"sensor", false}, {"turns", false}},
      {{"type", "segment"}, {"points", {{2, -1}, {2, 1}}}, {"sensor", false}, {"turns", false}},
      {{"type", "arc"},
       {"points", {{0, 1}}},
       {"radius", 2},
       {"angles", {0, 3.14159}},
       {"sensor", false},
       {"turns", false}},
      {{"type", "segment"}, {"points", {{-2, 1}, {-2, -1}}}, {"sensor", false}, {"turns", false}},
      {{"type", "circle"}, {"points", {{1.2, 0.6}}}, {"radius", 0.3}, {"sensor", false}, {"turns", false}},
      {{"type", "circle"}, {"points", {{-1.2, 1.6}}}, {"radius", 0.3}, {"sensor", true}, {"turns", false}},
      {{"type", "arc"},
       {"points", {{0, 2}}},
       {"radius", 0.2},
       {"angles", {0, 6.283185}},
       {"sensor", false},
       {"turns", false}},
      {{"type", "point"}, {"points", {{-1, 0.2}}}, {"sensor", false}, {"turns", false}},
      {{"type", "segment"},
       {"points", {{-0.4, 0.5}, {0.4, 0.5}}},
       {"center", {0, 0.5}},
       {"sensor", false},
       {"turns", true}}};
}

constexpr double g_fUnit = 0.001;
constexpr int g_nFrames = 31;

// Second differences in units, as the page has them. @param track  x and y of two balls, frame by frame
json Pack(const json& track) {
  json packed = json::array();
  const auto at = [&](std::size_t i, std::size_t frames) {
    return i < 4 * frames ? 0 : std::lround(track[i - 4 * frames].get<double>() / g_fUnit);
  };
  for (std::size_t i = 0; i < track.size(); ++i)
    packed.push_back(at(i, 0) - 2 * at(i, 1) + at(i, 2));
  return packed;
}

// Balls that bounce on the floor at y = -1. `sink` is how far the engine lets them in.
json Track(int frames, double sink, double sideways) {
  json track = json::array();
  for (int f = 0; f < frames; ++f)
    for (int ball = 0; ball < 2; ++ball) {
      const double t = f / 60.0, bounce = g_nWorstContact / 60.0, x0 = ball == 0 ? -1 : 0.3;
      const double after = std::max(0.0, t - bounce);
      const double y = -0.9 + 6 * std::abs(t - bounce) - (after > 0 ? sink : 0.0);
      track.push_back(x0 + 2 * t + sideways * after);
      track.push_back(y);
    }
  return track;
}

json Clip(const std::string& name, const std::string& title, const std::string& what, int contact) {
  json angles = json::array();
  for (int f = 0; f < g_nFrames; ++f)
    angles.push_back(f * 0.1);
  return {{"name", name},
          {"title", title},
          {"what", what},
          {"contact", contact},
          {"ball", g_nWorstBall},
          {"frames", g_nFrames},
          {"tracks", {0, 1, 2, 3, 4, 5}},
          {"orientations", {angles}}};
}

// Of the engines and the reference, in all clips.
json Tracks() {
  json tracks = json::array();
  for (const auto& [sink, sideways] :
       {std::pair(0.02, 0.5), {0.08, 1.5}, {0.04, 0.8}, {-0.02, 0.3}, {0.0, 0.1}, {0.0, 0.0}})
    tracks.push_back(Pack(Track(g_nFrames, sink, sideways)));
  return tracks;
}

// Engines that lie close together: labels have to make room for each other.
CChart MakeChart() {
  const double ns[] = {216, 102, 205, 1457, 1350}, error[] = {1e-7, 1.55, 1e-7, 0.21, 8e-4};
  const std::size_t lost[] = {7, 3000, 0, 50, 7};
  CChart chart{"Time against error", "from the best scene to the worst", {}};
  for (std::size_t e = 0; e < GetEngineRows().size(); ++e)
    chart.m_stdPoints.push_back({&GetEngineRows()[e],
                                 ns[e],
                                 {0.6 * ns[e], 3 * ns[e]},
                                 error[e],
                                 {0, 2 * error[e]},
                                 lost[e],
                                 30000,
                                 e < 3});
  return chart;
}

json MakeOverallJson(const CChart& chart) {
  json engines = json::array();
  for (const CChartPoint& p : chart.m_stdPoints)
    engines.push_back({{"name", p.m_pRow->m_sName},
                       {"grade", GetName(GradeOf(p.m_nLost, p.m_nOf, p.m_fError))},
                       {"tunneled", Rate(int(p.m_nLost), int(p.m_nOf))},
                       {"compared", 29000},
                       {"direction_error_p95", p.m_fError},
                       {"direction_error_p95_interval", {0.9 * p.m_fError, 1.1 * p.m_fError}},
                       {"direction_error_p95_scenes", {0, 2 * p.m_fError}},
                       {"ns_per_ball_step", p.m_fNs},
                       {"ns_per_ball_step_interval", {0.98 * p.m_fNs, 1.02 * p.m_fNs}},
                       {"ns_per_ball_step_scenes", {0.6 * p.m_fNs, 3 * p.m_fNs}},
                       {"ns_box2d_ratio", 1457 / p.m_fNs},
                       {"ns_box2d_ratio_interval", {1400 / p.m_fNs, 1500 / p.m_fNs}},
                       {"ns_box2d_ratio_scenes", {700 / p.m_fNs, 3000 / p.m_fNs}},
                       {"front", p.m_bFront}});
  return {{"impacts", 30000},
          {"scenes", 15},
          {"take", "native"},
          {"result",
           "Take native: 7.1 times faster than Box2D. It loses 7 of 30,000 balls (Box2D 50), and 95% of its "
           "bounces are within "
           "0.001 degrees (Box2D 12 degrees); native-approximate is 2.1 times faster but loses 1 in 10."},
          {"engines", std::move(engines)}};
}

} // namespace

CPageDocuments MakePageDocuments(const std::vector<std::string>& scenes) {
  json run{{"version", g_nRunVersion},
           {"command", "shapes-compare run --contacts 20000"},
           {"seed", 1},
           {"contacts_per_scene", 20000},
           {"interrupted", false},
           {"machine",
            {{"shapes", "0.1.0 (1234567)"},
             {"box2d", "2.4.1"},
             {"compiler", "g++ 12.2.0, Release"},
             {"cpu", "Some CPU"},
             {"cores", 8}}},
           {"figures", json::array()},
           {"histogram_edges", json::array()},
           {"scenes", json::array()},
           {"work_precision", json::array()},
           {"effects", json::array()}};
  for (const CFigure& figure : GetFigures())
    run["figures"].push_back({{"key", figure.m_sKey},
                              {"kind", GetKind(figure)},
                              {"group", figure.m_sGroup},
                              {"label", figure.m_sLabel},
                              {"unit", figure.m_sUnit},
                              {"signed", figure.m_bIsSigned}});
  for (std::size_t i = 0; i <= g_nBins; ++i)
    run["histogram_edges"].push_back(std::pow(10, double(i) / 4 - 6));
  json names = json::array();
  for (const CEngineRow& row : GetEngineRows()) {
    names.push_back(row.m_sName);
    run["engines"].push_back(
        {{"name", row.m_sName}, {"short", row.m_sShort}, {"meaning", row.m_sMeaning}, {"mark", row.m_sMark}});
  }
  names.push_back("exact");
  const CChart chart = MakeChart();
  if (!scenes.empty()) run["overall"] = MakeOverallJson(chart);
  json charts{{"overall", {DrawChart(chart, g_cWideChart, false), DrawChart(chart, g_cNarrowChart, false)}},
              {"scenes", json::object()}};
  json replay{{"engines", names}, {"scenes", json::array()}};
  std::uint64_t seed = 0;
  for (const std::string& name : scenes) {
    CNumbers figures(++seed);
    run["scenes"].push_back(Scene(name, figures));
    for (json& row : Work(name, figures))
      run["work_precision"].push_back(std::move(row));
    AddEffects(name, run["effects"]);
    charts["scenes"][name] = DrawChart(chart, g_cNarrowChart, false);
    replay["scenes"].push_back(
        {{"name", name},
         {"time_step", 1.0 / 60},
         {"bounds", {{"left", -10}, {"bottom", -10}, {"right", 10}, {"top", 10}}},
         {"radii", {0.1, 0.15}},
         {"shapes", Shapes()},
         {"unit", g_fUnit},
         {"tracks", Tracks()},
         {"clips",
          {Clip("start", "First trial", "", 0),
           Clip("worst native", "Worst contact of native", "sent off 0.61 rad from the exact direction",
                g_nWorstContact),
           Clip("worst native-approximate", "Worst contact of native-approximate", "sent off 0.7 rad",
                g_nWorstContact),
           Clip("worst box2d", "Worst contact of box2d", "set back 0.1 radii too far", g_nWorstContact),
           Clip("worst box2d-tuned", "Worst contact of box2d-tuned", "sent off a little",
                g_nWorstContact)}}});
  }
  return {std::move(run), std::move(replay), std::move(charts)};
}

CPageDocuments MakeSparsePageDocuments() {
  CPageDocuments report = MakePageDocuments({"full", "no_contacts", "one_engine", "nulls", "no_clips"});
  report.m_cRun["interrupted"] = true;
  const auto dropWork = [&](const std::string& scene) {
    json& rows = report.m_cRun["work_precision"];
    rows.erase(
        std::remove_if(rows.begin(), rows.end(), [&](const json& row) { return row["scene"] == scene; }),
        rows.end());
  };

  json& none = report.m_cRun["scenes"][1];
  for (json& engine : none["engines"]) {
    for (auto& [key, value] : engine.items()) {
      if (value.is_object() && value.contains("median")) value = Summary(0, 0);
      if (value.is_object() && value.contains("rate")) value = Rate(0, 0);
      if (value.is_array() && !value.empty() && value[0].is_number_integer()) value = json(value.size(), 0);
    }
    for (const char* pKey : {"contacts", "correct", "bounces"})
      engine[pKey] = 0;
    engine["bins"] = json::array();
    engine["ns_per_contact"] = nullptr;
  }
  none["heat_map"] = nullptr;
  none["quiet_steps"] = 0;
  for (json& row : report.m_cRun["work_precision"])
    if (row["scene"] == "no_contacts") {
      row["contacts"] = 0;
      row["miss_rate"] = row["tunneled_rate"] = Rate(0, 0);
      if (row["engine"] != "exact") row["direction_error_p95"] = nullptr;
    }

  json& single = report.m_cRun["scenes"][2];
  single["engines"] = json::array({single["engines"][0]}); // one in braces alone is a copy for some compilers
  single["apart"] = nullptr;
  single["heat_map"] = nullptr;

  json& nulls = report.m_cRun["scenes"][3];
  for (const char* pKey : {"description", "gravity", "features", "verdict", "remarks", "answers", "take",
                           "set_aside", "heat_map", "apart"})
    nulls[pKey] = nullptr;
  for (json& engine : nulls["engines"])
    for (auto& [key, value] : engine.items())
      if (key != "name") value = nullptr;
  dropWork("nulls");

  json& effects = report.m_cRun["effects"];
  effects.erase(std::remove_if(effects.begin(), effects.end(),
                               [](const json& row) { return row["scene"] == "one_engine"; }),
                effects.end());
  for (json& row : effects)
    if (row["scene"] == "nulls") {
      row["with"]["instructions_per_ball_step"] = row["without"]["instructions_per_ball_step"] = nullptr;
      row["runs"] = row["why"] = row["ns_ratio"] = row["ns_ratio_interval"] = nullptr;
      row["with"]["direction_error"] = Summary(0, 0);
    }
  nulls["not_counted"] = "valgrind is not there";

  // A ball that left the numbers, and a scene that was not recorded at all.
  json& nulled = report.m_cReplay["scenes"][3];
  for (std::size_t i = 80; i < 90; ++i)
    nulled["tracks"][0][i] = nullptr;
  nulled["clips"][0]["orientations"] = json::array();
  report.m_cReplay["scenes"][2]["clips"] = json::array();
  report.m_cReplay["scenes"].erase(4);
  report.m_cRun["scenes"][4]["features"] = {"gravity"};
  return report;
}

} // namespace Shapes::Compare
