// SPDX-License-Identifier: MIT
// Box2D asks the C library for sines, and C libraries round them differently: where shapes turn, a game in
// the browser would go another way than in the terminal. These come first, wherever Box2D is linked from. No
// header is included, because the C libraries declare them differently, too.

namespace Shapes::Games {
float GetSine(float angle);
float GetCosine(float angle);
} // namespace Shapes::Games

extern "C" {
float sinf(float angle) { return Shapes::Games::GetSine(angle); }
float cosf(float angle) { return Shapes::Games::GetCosine(angle); }
void sincosf(float angle, float* pSine, float* pCosine) {
  *pSine = Shapes::Games::GetSine(angle);
  *pCosine = Shapes::Games::GetCosine(angle);
}
}
