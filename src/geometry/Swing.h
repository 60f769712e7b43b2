// SPDX-License-Identifier: MIT
#pragma once

namespace Shapes::Geometry {

/// How far a point has turned on a circle, in radians, and how fast it does, in radians per second.
struct CSwing {
  double m_fAngle, m_fRate;
};

/// A point that slides on a circle without friction, where a constant acceleration pulls it: a pendulum. Of
/// the angle x that it has turned counterclockwise x'' = along cos x - out sin x. By the method of Nystroem
/// of fourth order (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.14): errors of the
/// fifth power of the time.
/// @param along, out  the acceleration at the beginning over the radius, counterclockwise and away from the
///                    middle; against these where the radius is taken as negative
/// @param rate  at the beginning, radians per second
/// @param time  seconds, not negative; what the point turns in it is to be much smaller than 1
inline CSwing GetSwing(double along, double out, double rate, double time) {
  // The cosine and the sine up to the fourth power, which is what the method asks for.
  const auto pull = [=](double x) {
    const double square = x * x;
    return along * (1.0 - square * (0.5 - square * (1.0 / 24.0))) - out * x * (1.0 - square * (1.0 / 6.0));
  };
  const double middle = pull((0.5 * rate + 0.125 * time * along) * time);
  const double last = pull((rate + 0.5 * time * middle) * time);
  const double sixth = time * (1.0 / 6.0);
  return {(rate + sixth * (along + 2.0 * middle)) * time, rate + sixth * (along + 4.0 * middle + last)};
}

} // namespace Shapes::Geometry
