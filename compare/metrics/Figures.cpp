// SPDX-License-Identifier: MIT
#include "Figures.h"

#include "report/Report.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

namespace Shapes::Compare {
namespace {

using C = CEngineContact;
using S = CSceneReport;
using E = CEngineReport;

constexpr const char* g_sOutcomes = "Outcomes";
constexpr const char* g_sClaims =
    "What CollisionDetected claims (the same in every profile of Box2D): median / p95 / max";
constexpr const char* g_sResponses = "Correct responses against the exact ones: median / p95 / max";
constexpr const char* g_sLongRun = "Long run";
constexpr const char* g_sLasting = "Contact that lasts";
constexpr const char* g_sCost = "Cost";

bool IsDetected(const C& c) { return c.m_bDetected; }
bool IsReported(const C& c) { return c.HasTurnedBack() && c.m_bReported; }
bool IsCompared(const C& c) { return c.m_bCompared; }

CHits OfImpacts(const E& e, std::size_t hits) { return {hits, e.m_cTotals.m_nContacts}; }

constexpr CFigure RateOf(const char* of, const char* key, const char* group, const char* label,
                         CHits (*pRate)(const S&, const E&)) {
  CFigure figure{key, group, label, "rate"};
  figure.m_pRate = pRate;
  figure.m_sRateOf = of;
  return figure;
}

constexpr CFigure Rate(const char* key, const char* label, CHits (*pRate)(const S&, const E&)) {
  return RateOf("impacts", key, g_sOutcomes, label, pRate);
}

constexpr CFigure OfImpact(const char* key, const char* group, const char* label, const char* unit,
                           bool isSigned, float C::*pValue, bool (*pIsMeasured)(const C&)) {
  CFigure figure{key, group, label, unit, isSigned};
  figure.m_pOfImpact = pValue;
  figure.m_pIsMeasured = pIsMeasured;
  return figure;
}

// A ball that tunneled is as deep as it flies; that is no penetration to be summarised.
constexpr CFigure OfTurnedBack(CFigure figure) {
  figure.m_pIsSummarised = [](const C& c) { return !c.HasTunneled(); };
  return figure;
}

constexpr CFigure OfRun(const char* key, const char* group, const char* label, const char* unit,
                        bool isSigned, std::optional<double> (*pOfRun)(const S&, const E&)) {
  CFigure figure{key, group, label, unit, isSigned};
  figure.m_pOfRun = pOfRun;
  return figure;
}

constexpr CFigure CountOfRun(const char* key, const char* group, const char* label, const char* unit,
                             std::optional<double> (*pOfRun)(const S&, const E&)) {
  CFigure figure = OfRun(key, group, label, unit, false, pOfRun);
  figure.m_bIsCount = true;
  return figure;
}

constexpr CFigure g_stdFigures[] = {
    Rate("late", "late", [](const S&, const E& e) { return OfImpacts(e, e.m_cTotals.m_nLate); }),
    Rate("missed", "missed", [](const S&, const E& e) { return OfImpacts(e, e.m_cTotals.m_nMissed); }),
    Rate("wrong_side", "wrong side",
         [](const S&, const E& e) { return OfImpacts(e, e.m_cTotals.m_nWrongSide); }),
    Rate("tunneled", "tunneled",
         [](const S&, const E& e) { return OfImpacts(e, e.m_cTotals.GetTunneled()); }),
    Rate("overlapped", "overlapped",
         [](const S&, const E& e) { return OfImpacts(e, e.m_cTotals.m_nOverlapped); }),
    RateOf("quiet steps", "ghost", g_sOutcomes, "ghost, of quiet steps",
           [](const S& s, const E& e) {
             return CHits{e.m_nGhosts, s.m_cImpactTrials.m_nQuietSteps};
           }),

    OfImpact("setback", g_sClaims, "setback", "radii", false, &C::m_fSetback, IsDetected),
    OfImpact("setback_error", g_sClaims, "setback error", "radii", false, &C::m_fSetbackError, IsDetected),
    OfImpact("setback_error_normal", g_sClaims, "along the normal, out is +", "radii", true,
             &C::m_fSetbackErrorNormal, IsDetected),
    OfImpact("time_error", g_sClaims, "in time, late is +", "steps", true, &C::m_fTimeError, IsDetected),
    OfImpact("poi_error", g_sResponses, "place of the impact", "radii", false, &C::m_fPOIError, IsReported),
    OfImpact("normal_error", g_sResponses, "normal", "rad", false, &C::m_fNormalError, IsReported),
    OfImpact("direction_error", g_sResponses, "direction", "rad", false, &C::m_fDirectionError, IsCompared),
    OfImpact("speed_error", g_sResponses, "speed", "relative", true, &C::m_fSpeedError, IsCompared),
    OfImpact("energy_error", g_sResponses, "energy", "relative", true, &C::m_fEnergyError, IsCompared),
    OfImpact("position_error", g_sResponses, "position", "radii", false, &C::m_fPositionError, IsCompared),
    OfTurnedBack(OfImpact("penetration", g_sResponses, "penetration (all that did not tunnel)", "radii",
                          false, &C::m_fPenetration, [](const C&) { return true; })),

    OfRun("energy_drift", g_sLongRun, "energy drift over these bounces", "change", true,
          [](const S&, const E& e) { return e.m_cLongRun.m_fEnergyDrift; }),
    OfRun("free_path_error", g_sLongRun, "free path error", "change", true,
          [](const S&, const E& e) { return e.m_cLongRun.m_fFreePathError; }),
    OfRun("angular_momentum_drift", g_sLongRun, "angular momentum drift over these bounces", "change", true,
          [](const S&, const E& e) { return e.m_cLongRun.m_fAngularMomentumDrift; }),

    RateOf("balls", "lasting_lost", g_sLasting, "balls lost",
           [](const S&, const E& e) {
             return CHits{e.m_cLasting.m_nLost, e.m_cLasting.m_nBalls};
           }),
    OfRun("lasting_overlap", g_sLasting, "deepest overlap at the end", "radii", false,
          [](const S&, const E& e) { return e.m_cLasting.m_fOverlap; }),
    OfRun("lasting_speed", g_sLasting, "fastest ball at the end", "units/s", false,
          [](const S&, const E& e) { return e.m_cLasting.m_fSpeed; }),
    OfRun("lasting_energy_gained", g_sLasting, "energy from nothing", "change", false,
          [](const S&, const E& e) { return e.m_cLasting.m_fEnergyGained; }),
    OfRun("rest_time", g_sLasting, "time until all are at rest", "s", false,
          [](const S&, const E& e) { return e.m_cLasting.m_fRestTime; }),
    OfRun("flow", g_sLasting, "flow past the sensors", "balls/s", false,
          [](const S&, const E& e) { return e.m_cLasting.m_fFlow; }),
    OfRun("lasting_ns_per_ball_step", g_sLasting, "time per ball and step", "ns", false,
          [](const S&, const E& e) {
            return e.m_cLasting.m_nBalls == 0 ? std::optional<double>()
                                              : e.m_cLasting.m_cNsPerBallStep.m_fMedian;
          }),

    OfRun("ns_per_ball_step", g_sCost, "time per ball and step", "ns", false,
          [](const S&, const E& e) { return std::optional(e.m_cCost.m_cNsPerBallStep.m_fMedian); }),
    OfRun("ns_per_contact", g_sCost, "time per contact", "ns", false,
          [](const S&, const E& e) { return e.m_cCost.GetNsPerContact(); }),
    CountOfRun("escaped", g_sCost, "escaped while timed", "balls",
               [](const S&, const E& e) { return std::optional(static_cast<double>(e.m_cCost.m_nEscaped)); }),
    CountOfRun(
        "not_finite", g_sCost, "not finite while timed", "balls",
        [](const S&, const E& e) { return std::optional(static_cast<double>(e.m_cCost.m_nNotFinite)); }),
};

constexpr bool IsOfImpact(const CFigure& figure) { return figure.m_pOfImpact != nullptr; }

} // namespace

const char* GetKind(const CFigure& figure) {
  if (figure.m_pRate != nullptr) return "rate";
  if (figure.m_bIsCount) return "count";
  return IsOfImpact(figure) ? "impact" : "run";
}

std::span<const CFigure> GetFigures() { return g_stdFigures; }

std::span<const CFigure> GetImpactFigures() {
  constexpr auto pFirst = std::find_if(std::begin(g_stdFigures), std::end(g_stdFigures), IsOfImpact);
  constexpr auto n = std::count_if(std::begin(g_stdFigures), std::end(g_stdFigures), IsOfImpact);
  static_assert(IsOfImpact(pFirst[n - 1]),
                "rows of OfImpact have to stand one after the other in g_stdFigures");
  return {pFirst, static_cast<std::size_t>(n)};
}

const CFigure* FindFigure(std::string_view key) {
  for (const CFigure& figure : g_stdFigures)
    if (figure.m_sKey == key) return &figure;
  return nullptr;
}

std::size_t GetImpactFigureIndex(std::string_view key) {
  const auto figures = GetImpactFigures();
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (figures[i].m_sKey == key) return i;
  throw std::out_of_range("no figure of an impact: " + std::string(key));
}

std::optional<double> GetLimited(const CFigure& figure, const CSceneReport& scene,
                                 const CEngineReport& engine) {
  if (figure.m_pRate != nullptr) {
    const CHits rate = figure.m_pRate(scene, engine);
    if (rate.m_nOf == 0) return {};
    return static_cast<double>(rate.m_nHits) / static_cast<double>(rate.m_nOf);
  }
  if (IsOfImpact(figure)) return engine.m_cTotals[figure.m_sKey].GetP95();
  const auto value = figure.m_pOfRun(scene, engine);
  return value ? std::optional(std::abs(*value)) : value;
}

} // namespace Shapes::Compare
