// SPDX-License-Identifier: MIT
// Shapes that turn, and what they do to a ball.
#include "StepTesting.h"

namespace Shapes::HardCases {
namespace {

// ---- The kick.

/// A segment turns about the origin. In the middle of the step it lies on the x axis, and meets a ball of
/// r = .1 at x = 1, where its surface moves at V along the normal; the ball moves at vn along it, and at .5
/// across. side = -1 is the mirror image, below the axis.
struct CKick {
  double m_fSurface; // V
  double m_fBall;    // vn
  float m_fElasticity;
};

double Kick(eColumn column, const CKick& kick, double side) {
  const float r = 0.1f, revs = static_cast<float>(side * kick.m_fSurface / (2.0 * std::numbers::pi));
  const double half = 0.5 * g_fDt;
  const auto a0 = static_cast<float>(
      std::fmod(2.0 * std::numbers::pi - side * kick.m_fSurface * half, 2.0 * std::numbers::pi));
  const Vector2 v(0.5f, static_cast<float>(side * kick.m_fBall));
  const Vector2 p0(static_cast<float>(1 - .5 * half), static_cast<float>(side * (r - kick.m_fBall * half)));
  CStepped stepped(column, {Turning(CLineSegDesc({-3, 0}, {3, 0}, kick.m_fElasticity), revs)},
                   {CDynamicCircleDesc(p0, r, v)});
  stepped.SetOrientation(0, a0);
  stepped.Step();

  // When the distance from the line is r: Newton from the middle of the step, on the rounded input.
  const CFifty w = 2 * boost::math::constants::pi<CFifty>() * CFifty(revs), dt = g_fDt;
  const CVec<CFifty> q0 = p0.cast<CFifty>(), u = v.cast<CFifty>();
  CFifty t = dt / 2;
  CVec<CFifty> p, n, along;
  for (int i = 0; i < 8; ++i) {
    const CFifty a = CFifty(a0) + w * t;
    along = {cos(a), sin(a)};
    n = CFifty(side) * CVec<CFifty>(-along.y(), along.x());
    p = q0 + u * t;
    t -= (n.dot(p) - r) / (n.dot(u) - CFifty(side) * w * along.dot(p));
  }
  const CFifty surface = CFifty(side) * w * along.dot(p), e = kick.m_fElasticity;
  const CVec<CFifty> after = u + (1 + e) * (surface - n.dot(u)) * n, end = p + after * (dt - t);
  return OffBy(stepped, end.cast<double>(), after.cast<double>());
}

/// Reflected as if static, then e (V - v) on top.
double NaiveKick(const CKick& kick) {
  const double V = kick.m_fSurface, vn = kick.m_fBall, e = kick.m_fElasticity;
  const double flipped = vn < 0.0 ? -e * vn : vn;
  return std::abs(flipped + e * (V - vn) - (V + e * (V - vn)));
}

CHardCase KickOf(const std::string& name, const CKick& kick, const std::string& input,
                 const std::string& right, const std::string& naive, const CExpect& approximate,
                 const CExpect& shipped, const CExpect& tuned) {
  return Case(
      name, input + "; the mirror image too", right, g_cEightRoundings,
      {{Approximate, approximate}, {Box2D, shipped}, {Tuned, tuned}},
      [=](eColumn column) { return Worst(Kick(column, kick, 1.0), Kick(column, kick, -1.0)); },
      "reflected as if static, then e (V - vn) on top: " + naive, [=] { return NaiveKick(kick); });
}

CExpect AtTheEndOfTheStep(double figure, const std::string& text) {
  return Off(figure, text + ": it meets the segment where it is at the end of the step");
}

// ---- It stands still.

/// The largest difference of places and velocities on the way from those at a static segment.
double StandsStill(eColumn column) {
  const CLineSegDesc wall({-3.0f, -0.7f}, {3.0f, 0.4f}, 0.8f);
  const std::vector<CDynamicCircleDesc> ball{CDynamicCircleDesc({0.1f, 0.5f}, 0.1f, {1.0f, -3.0f})};
  CStepped still(column, {wall}, ball, g_fDt, {0, -9.8f}),
      kinematic(column, {Turning(wall)}, ball, g_fDt, {0, -9.8f});
  return WorstOf(120, [&](int) {
    still.Step();
    kinematic.Step();
    return Worst((still.GetPos() - kinematic.GetPos()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
                 (still.GetVel() - kinematic.GetVel()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  });
}

// ---- One turn a step.

double OneTurnAStep(eColumn column) {
  const float r = 0.1f, d = 0.5f, revs = 60.0f;
  return WorstOf(11, [=](int i) {
    const Vector2 p = Turned(d, 0, (i + 1) * std::numbers::pi / 6.0);
    CStepped stepped(column, {Turning(CLineSegDesc({0, 0}, {1, 0}), revs)}, {CDynamicCircleDesc(p, r)});
    stepped.Step();
    const Vector2d q = Wide(p);
    const double away = q.norm(), turn = std::atan2(q.y(), q.x()) - std::asin(r / away);
    const double angle = turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn;
    const double w = 2.0 * std::numbers::pi * revs, foot = std::sqrt((away - r) * (away + r));
    const Vector2d after = 2.0 * w * foot * Vector2d(-std::sin(angle), std::cos(angle));
    const Vector2d end = q + after * (g_fDt - angle / w);
    return Worst(Distance(stepped.GetVel(), after), Distance(stepped.GetPos(), end)) / after.norm();
  });
}

// ---- A million radians.

/// Error of the orientation, in radians, and of the ends, by their distance.
double MillionRadians(eColumn column) {
  const float angle = 1e6f;
  CStepped stepped(column, {Turning(CLineSegDesc({1, 0}, {2, 0}), 0.0f)}, {});
  stepped.SetOrientation(0, angle);
  const CFifty tau = 2 * boost::math::constants::pi<CFifty>(), right = fmod(CFifty(angle), tau);
  CFifty orientation;
  CVec<CFifty> p0, p1;
  if (stepped.GetWorld() == nullptr) {
    orientation = stepped.GetReference().GetOrientation(0);
    const auto figure = stepped.GetReference().GetGeometry(0);
    p0 = figure.m_vPt0.cast<CFifty>();
    p1 = figure.m_vPt1.cast<CFifty>();
  } else {
    const CShapeId id = stepped.GetShapeId(0);
    orientation = stepped.GetWorld()->GetOrientation(id);
    const auto& segment = dynamic_cast<const CLineSeg&>(stepped.GetWorld()->GetShape(id));
    p0 = segment.GetEndPt0().cast<CFifty>();
    p1 = segment.GetEndPt1().cast<CFifty>();
  }
  if (p0.norm() > p1.norm()) std::swap(p0, p1);
  const CVec<CFifty> u(cos(right), sin(right));
  const CFifty error = std::max(
      {CFifty(abs(orientation - right)), CFifty((p0 - u).norm()), CFifty((p1 - CFifty(2) * u).norm())});
  return static_cast<double>(error);
}

// ---- Through the vertical.

constexpr float g_fUp = std::numbers::pi_v<float> / 2.0f;

/// The worst of f of each angle near the vertical.
template <class F>
double NearTheVertical(const F& f) {
  return WorstOf({g_fUp - 0.1f, g_fUp - 1e-3f, std::nextafter(g_fUp, 0.0f), g_fUp,
                  std::nextafter(g_fUp, 2.0f), g_fUp + 1e-3f, g_fUp + 0.1f},
                 f);
}

/// The error, relative, of the velocity of a ball that comes to a one-sided segment at that angle, from its
/// front, side = 1, or its back, -1.
double AtAGate(eColumn column, float angle, double side) {
  const CLineSegDesc gate = Sided(Turning(CLineSegDesc({-1, 0}, {1, 0})), eSides::Front);
  const Vector2d n(-std::sin(Wide(angle)), std::cos(Wide(angle)));
  const Vector2 v = (-side * 6.0 * n).cast<float>() + Vector2(0.0f, 0.5f);
  CStepped stepped(column, {gate}, {CDynamicCircleDesc((side * 0.12 * n).cast<float>(), 0.1f, v)});
  stepped.SetOrientation(0, angle);
  stepped.Step(2);
  const Vector2d right = side > 0.0 ? Mirrored(Wide(v), n) : Wide(v);
  return Distance(stepped.GetVel(), right) / right.norm();
}

double ThroughTheVertical(eColumn column) {
  return NearTheVertical([=](float angle) {
    return WorstOf({angle, angle + std::numbers::pi_v<float>},
                   [=](float a) { return Worst(AtAGate(column, a, 1.0), AtAGate(column, a, -1.0)); });
  });
}

double NaiveThroughTheVertical() {
  return NearTheVertical([](double a) {
    Vector2d p0(-std::cos(a), -std::sin(a)), p1 = -p0;
    if (p1.x() < p0.x()) std::swap(p0, p1);
    const Vector2d along = (p1 - p0).normalized(), n(-along.y(), along.x()), front(-std::sin(a), std::cos(a)),
                   v = -6.0 * front;
    return Distance(v.dot(n) < 0.0 ? Mirrored(v, n) : v, Mirrored(v, front)) / v.norm();
  });
}

} // namespace

std::vector<CHardCase> KinematicCases() {
  const CExpect elsewhere = RightWithin(0x1p-20, "2 roundings of 8; its body has another origin");
  return {
      Case("StandingStillIsStatic",
           "A kinematic segment with a rotation speed of 0, and a static one: r = .1 bouncing and sliding on "
           "it for 2 s, e = .8: largest difference of places and velocities",
           "0", g_cBits, {{Box2D, elsewhere}, {Tuned, elsewhere}}, StandsStill,
           "e (V - v) on top of the static response: vn = -1, V = 0, e = 1 gives 2 instead of 1",
           [] {
             return NaiveKick({0.0, -1.0, 1.0f});
           }),
      KickOf("KickAgainstTheBall", {2.0, -1.0, 1.0f},
             "A segment turns at V = 2 along its normal, r = .1 comes at vn = -1, e = 1", "vn' = 5", "4",
             AtTheEndOfTheStep(0.025, ".025"), Off(0.0043, ".0043: its skin and slop"),
             Off(0.00053, ".00053: a quarter of its slop")),
      KickOf("KickFromBehind", {2.0, 1.0, 1.0f}, "V = 2 catches up with vn = 1, e = 1", "vn' = 3", "2",
             AtTheEndOfTheStep(0.017, ".017"), Off(0.017, ".017: its skin and slop"),
             Off(0.0013, ".0013: a quarter of its slop")),
      KickOf("KickOfABallAtRest", {std::numbers::pi, 0.0, 0.5f}, "V = pi, vn = 0, e = .5", "vn' = 4.712",
             "1.571", AtTheEndOfTheStep(0.028, ".028"), Off(0.0054, ".0054: its skin and slop"),
             Off(0.00067, ".00067: a quarter of its slop")),
      KickOf("SurfaceThatRetreats", {-0.5, -1.0, 1.0f}, "V = -.5, vn = -1, e = 1", "vn' = 0", "1.5",
             AtTheEndOfTheStep(0.018, ".018"), Off(0.018, ".018: its skin and slop"),
             Off(0.0027, ".0027: a quarter of its slop")),
      Case("OneTurnAStep",
           "A hand of length 1 turns 60 times a second, at 60 steps a second; r = .1 at rest, .5 from the "
           "centre, at eleven places around it: velocity and place after a step, relative to the speed",
           "hit within the turn, by 2 V = 369", g_cEightRoundings,
           {{Approximate, Deviates(0.99, 1.01, "missed: it looks at the end of the step only")},
            {Box2D, Deviates(0.99, 1.01, "missed at some places: it turns by pi/2 a step at most; counted")},
            {Tuned, Deviates(0.0006, 0.0025, ".0012: a quarter of its slop")}},
           OneTurnAStep, "angle at the end of the step: the same as before, nothing has moved",
           [] {
             const double turn = 2.0 * std::numbers::pi;
             return std::abs(std::remainder(turn * 60.0 / 60.0, turn)) < 0.1 ? 1.0 : 0.0;
           }),
      Case("AMillionRadians",
           "A segment from (1, 0) to (2, 0), turned about the origin to 1e6 rad: its angle, and its ends",
           "1e6 mod 2 pi = 5.92562114 rad; both radii kept",
           {1e-12, 8 * g_fFloatRounding, "1e-12; engines 8 roundings of 1: one of the angle"}, {},
           MillionRadians, "1e6 rad summed up in float, by 2 pi / 60 a step: .0625 rad apart there",
           [] {
             float angle = 0.0f;
             const float step = 6.2831853f / 60.0f;
             const int steps = 9549297;
             for (int i = 0; i < steps; ++i)
               angle += step;
             return std::abs(angle - steps * Wide(step));
           }),
      Case("ThroughTheVertical",
           "A segment solid on one side, turned to the vertical, a rounding to either side of it, .001 and "
           ".1 rad from it, up and down; r = .1 at 6 units/s to the solid side and to the open one: "
           "velocity, relative",
           "bounces off the solid side, passes from the open one: it does not change sides", Roundings(8), {},
           ThroughTheVertical,
           "normal from the ends, the left one first: turns by 180 degrees at the vertical",
           NaiveThroughTheVertical)};
}

} // namespace Shapes::HardCases
