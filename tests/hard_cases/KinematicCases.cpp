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
  const Vector2 p0(static_cast<float>(1.0 - 0.5 * half),
                   static_cast<float>(side * (r - kick.m_fBall * half)));
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
                 const std::string& right, const std::string& naive, const CExpectations& expect) {
  return {name,
          input + "; the mirror image too",
          right,
          g_cEightRoundings,
          expect,
          [=](eColumn column) { return Worst(Kick(column, kick, 1.0), Kick(column, kick, -1.0)); },
          "reflected as if static, then e (V - vn) on top: " + naive,
          [=] { return NaiveKick(kick); }};
}

// ---- It stands still.

/// The largest difference of places and velocities on the way from those at a static segment.
double StandsStill(eColumn column) {
  const auto fly = [&](bool kinematic) {
    const CLineSegDesc wall(Vector2(-3.0f, -0.7f), Vector2(3.0f, 0.4f), 0.8f);
    CStepped stepped(column, {kinematic ? Turning(wall, 0.0f) : wall},
                     {CDynamicCircleDesc({0.1f, 0.5f}, 0.1f, {1.0f, -3.0f})}, g_fDt, {0, -9.8f});
    std::vector<double> way;
    for (int i = 0; i < 120; ++i) {
      stepped.Step();
      for (const double x :
           {stepped.GetPos().x(), stepped.GetPos().y(), stepped.GetVel().x(), stepped.GetVel().y()})
        way.push_back(x);
    }
    return way;
  };
  const std::vector<double> a = fly(false), b = fly(true);
  double different = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different = Worst(different, std::abs(a[i] - b[i]));
  return different;
}

// ---- One turn a step.

double OneTurnAStep(eColumn column) {
  const float r = 0.1f, d = 0.5f, revs = 60.0f;
  double worst = 0.0;
  for (int i = 1; i < 12; ++i) {
    const double phi = i * std::numbers::pi / 6.0;
    const Vector2 p = Turned(d, 0, phi);
    CStepped stepped(column, {Turning(CLineSegDesc({0, 0}, {1, 0}), revs)}, {CDynamicCircleDesc(p, r)});
    stepped.Step();
    const Vector2d q = p.cast<double>();
    const double away = q.norm(), turn = std::atan2(q.y(), q.x()) - std::asin(r / away);
    const double angle = turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn;
    const double w = 2.0 * std::numbers::pi * revs, foot = std::sqrt((away - r) * (away + r));
    const Vector2d after = 2.0 * w * foot * Vector2d(-std::sin(angle), std::cos(angle));
    const Vector2d end = q + after * (g_fDt - angle / w);
    worst = Worst(worst,
                  Worst(Distance(stepped.GetVel(), after), Distance(stepped.GetPos(), end)) / after.norm());
  }
  return worst;
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

const std::vector<float>& Angles() {
  static const float up = std::numbers::pi_v<float> / 2.0f;
  static const std::vector<float> angles{
      up - 0.1f, up - 1e-3f, std::nextafter(up, 0.0f), up, std::nextafter(up, 2.0f), up + 1e-3f, up + 0.1f};
  return angles;
}

/// The velocity of a ball that comes to the solid side of a one-sided segment at that angle.
double ThroughTheVertical(eColumn column) {
  double worst = 0.0;
  for (const float below : {0.0f, std::numbers::pi_v<float>})
    for (const float angle : Angles()) {
      const float a = angle + below;
      const CLineSegDesc gate = Sided(Turning(CLineSegDesc({-1, 0}, {1, 0})), eSides::Front);
      const Vector2d n(-std::sin(static_cast<double>(a)), std::cos(static_cast<double>(a)));
      for (const double side : {1.0, -1.0}) {
        const Vector2 v = (-side * 6.0 * n).cast<float>() + Vector2(0.0f, 0.5f);
        CStepped stepped(column, {gate}, {CDynamicCircleDesc((side * 0.12 * n).cast<float>(), 0.1f, v)});
        stepped.SetOrientation(0, a);
        stepped.Step(2);
        const Vector2d before = v.cast<double>(), right = side > 0.0 ? Mirrored(before, n) : before;
        worst = Worst(worst, Distance(stepped.GetVel(), right) / right.norm());
      }
    }
  return worst;
}

double NaiveThroughTheVertical() {
  double worst = 0.0;
  for (const float angle : Angles()) {
    const double a = angle;
    Vector2d p0(-std::cos(a), -std::sin(a)), p1 = -p0;
    if (p1.x() < p0.x()) std::swap(p0, p1);
    const Vector2d n(-(p1 - p0).normalized().y(), (p1 - p0).normalized().x()),
        front(-std::sin(a), std::cos(a));
    const Vector2d v = -6.0 * front;
    worst = Worst(worst, Distance(v.dot(n) < 0.0 ? Mirrored(v, n) : v, Mirrored(v, front)) / v.norm());
  }
  return worst;
}

} // namespace

std::vector<CHardCase> KinematicCases() {
  const CExpect r = Right();
  return {{"StandingStillIsStatic",
           "A kinematic segment with a rotation speed of 0, and a static one: r = .1 bouncing and sliding on "
           "it for 2 s, e = .8: largest difference of places and velocities",
           "0",
           g_cBits,
           {Right(), Right(), RightWithin(0x1p-20, "2 roundings of 8; its body has another origin"),
            RightWithin(0x1p-20, "2 roundings of 8; its body has another origin"), Right()},
           StandsStill,
           "e (V - v) on top of the static response: vn = -1, V = 0, e = 1 gives 2 instead of 1",
           [] {
             return NaiveKick({0.0, -1.0, 1.0f});
           }},
          KickOf("KickAgainstTheBall", {2.0, -1.0, 1.0f},
                 "A segment turns at V = 2 along its normal, r = .1 comes at vn = -1, e = 1", "vn' = 5", "4",
                 {Deviates(0.0125, 0.05, ".025: it meets the segment where it is at the end of the step"), r,
                  Deviates(0.00215, 0.0086, ".0043: its skin and slop"),
                  Deviates(0.000265, 0.00106, ".00053: a quarter of its slop"), r}),
          KickOf("KickFromBehind", {2.0, 1.0, 1.0f}, "V = 2 catches up with vn = 1, e = 1", "vn' = 3", "2",
                 {Deviates(0.0085, 0.034, ".017: it meets the segment where it is at the end of the step"), r,
                  Deviates(0.0085, 0.034, ".017: its skin and slop"),
                  Deviates(0.00065, 0.0026, ".0013: a quarter of its slop"), r}),
          KickOf("KickOfABallAtRest", {std::numbers::pi, 0.0, 0.5f}, "V = pi, vn = 0, e = .5", "vn' = 4.712",
                 "1.571",
                 {Deviates(0.014, 0.056, ".028: it meets the segment where it is at the end of the step"), r,
                  Deviates(0.0027, 0.0108, ".0054: its skin and slop"),
                  Deviates(0.000335, 0.00134, ".00067: a quarter of its slop"), r}),
          KickOf("SurfaceThatRetreats", {-0.5, -1.0, 1.0f}, "V = -.5, vn = -1, e = 1", "vn' = 0", "1.5",
                 {Deviates(0.009, 0.036, ".018: it meets the segment where it is at the end of the step"), r,
                  Deviates(0.009, 0.036, ".018: its skin and slop"),
                  Deviates(0.00135, 0.0054, ".0027: a quarter of its slop"), r}),
          {"OneTurnAStep",
           "A hand of length 1 turns 60 times a second, at 60 steps a second; r = .1 at rest, .5 from the "
           "centre, at eleven places around it: velocity and place after a step, relative to the speed",
           "hit within the turn, by 2 V = 369",
           g_cEightRoundings,
           {Deviates(0.99, 1.01, "missed: it looks at the end of the step only"), Right(),
            Deviates(0.99, 1.01, "missed at some places: it turns by pi/2 a step at most; counted"),
            Deviates(0.0006, 0.0025, ".0012: a quarter of its slop"), Right()},
           [](eColumn column) { return OneTurnAStep(column); },
           "angle at the end of the step: the same as before, nothing has moved",
           [] {
             return std::abs(std::remainder(2.0 * std::numbers::pi * 60.0 / 60.0, 2.0 * std::numbers::pi)) <
                            0.1
                        ? 1.0
                        : 0.0;
           }},
          {"AMillionRadians",
           "A segment from (1, 0) to (2, 0), turned about the origin to 1e6 rad: its angle, and its ends",
           "1e6 mod 2 pi = 5.92562114 rad; both radii kept",
           {1e-12, 8 * g_fFloatRounding, "1e-12; engines 8 roundings of 1: one of the angle"},
           g_stdAllRight,
           MillionRadians,
           "1e6 rad summed up in float, by 2 pi / 60 a step: .0625 rad apart there",
           [] {
             float angle = 0.0f;
             const float step = 6.2831853f / 60.0f;
             const int steps = 9549297;
             for (int i = 0; i < steps; ++i)
               angle += step;
             return std::abs(angle - steps * static_cast<double>(step));
           }},
          {"ThroughTheVertical",
           "A segment solid on one side, turned to the vertical, a rounding to either side of it, .001 and "
           ".1 rad from it, up and down; r = .1 at 6 units/s to the solid side and to the open one: "
           "velocity, relative",
           "bounces off the solid side, passes from the open one: it does not change sides",
           {8 * g_fDoubleRounding, 8 * g_fFloatRounding, "8 roundings"},
           g_stdAllRight,
           [](eColumn column) { return ThroughTheVertical(column); },
           "normal from the ends, the left one first: turns by 180 degrees at the vertical",
           [] { return NaiveThroughTheVertical(); }}};
}

} // namespace Shapes::HardCases
