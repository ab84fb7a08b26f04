// Linear Rec. 709 colour: three channels of any quantity.
#pragma once

namespace aktina {

struct Rgb {
  float r = 0, g = 0, b = 0;

  constexpr Rgb() = default;
  constexpr explicit Rgb(float v) : r(v), g(v), b(v) {}
  constexpr Rgb(float red, float green, float blue) : r(red), g(green), b(blue) {}

  constexpr float operator[](int i) const { return i == 0 ? r : i == 1 ? g : b; }
  constexpr float& operator[](int i) { return i == 0 ? r : i == 1 ? g : b; }

  constexpr Rgb& operator+=(Rgb o) { return r += o.r, g += o.g, b += o.b, *this; }
  constexpr Rgb& operator-=(Rgb o) { return r -= o.r, g -= o.g, b -= o.b, *this; }
  constexpr Rgb& operator*=(Rgb o) { return r *= o.r, g *= o.g, b *= o.b, *this; }
  constexpr Rgb& operator*=(float s) { return r *= s, g *= s, b *= s, *this; }

  friend constexpr Rgb operator+(Rgb a, Rgb b) { return a += b; }
  friend constexpr Rgb operator-(Rgb a, Rgb b) { return a -= b; }
  friend constexpr Rgb operator*(Rgb a, Rgb b) { return a *= b; }
  friend constexpr Rgb operator*(Rgb a, float s) { return a *= s; }
  friend constexpr Rgb operator*(float s, Rgb a) { return a *= s; }
  friend constexpr Rgb operator/(Rgb a, float s) { return a *= 1 / s; }
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// Relative luminance of linear Rec. 709.
constexpr float luminance(Rgb c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }
constexpr float max_channel(Rgb c) { return c.r > c.g ? (c.r > c.b ? c.r : c.b) : (c.g > c.b ? c.g : c.b); }
constexpr float min_channel(Rgb c) { return c.r < c.g ? (c.r < c.b ? c.r : c.b) : (c.g < c.b ? c.g : c.b); }
constexpr float mean(Rgb c) { return (c.r + c.g + c.b) * (1.0f / 3); }
constexpr bool is_black(Rgb c) { return c.r == 0 && c.g == 0 && c.b == 0; }
inline bool is_finite(Rgb c) { return __builtin_isfinite(c.r) && __builtin_isfinite(c.g) && __builtin_isfinite(c.b); }
constexpr Rgb clamped(Rgb c, float low, float high) {
  for (int i = 0; i < 3; ++i) c[i] = c[i] < low ? low : c[i] > high ? high : c[i];
  return c;
}

}  // namespace aktina
