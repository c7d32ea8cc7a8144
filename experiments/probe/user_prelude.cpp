#include "experiments/probe/user_prelude.h"

namespace twintrace::probe {

std::string_view userPrelude() {
  return R"prelude(#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
namespace shader {
using uint = std::uint32_t;
template <class T> concept Integer = std::same_as<T, int> || std::same_as<T, uint>;
template <class T, int N> struct Vector;
template <class T> struct Vector<T, 2> {
  union { T x{}; T r, s; }; union { T y{}; T g, t; };
  Vector() = default;
  explicit Vector(T s) : x(s), y(s) {}
  Vector(T a, T b) : x(a), y(b) {}
  template <class U> explicit Vector(const Vector<U, 2>& v) : x(T(v.x)), y(T(v.y)) {}
  template <class U, int M> requires(M > 2) explicit Vector(const Vector<U, M>& v) : x(T(v.x)), y(T(v.y)) {}
  T& operator[](int i) { return i == 0 ? x : y; }
  const T& operator[](int i) const { return i == 0 ? x : y; }
  template <int... I> auto swizzle() const { return Vector<T, sizeof...(I)>((*this)[I]...); }
};
template <class T> struct Vector<T, 3> {
  union { T x{}; T r, s; }; union { T y{}; T g, t; }; union { T z{}; T b, p; };
  Vector() = default;
  explicit Vector(T s) : x(s), y(s), z(s) {}
  Vector(T a, T b, T c) : x(a), y(b), z(c) {}
  Vector(const Vector<T, 2>& v, T c) : x(v.x), y(v.y), z(c) {}
  Vector(T a, const Vector<T, 2>& v) : x(a), y(v.x), z(v.y) {}
  template <class U> explicit Vector(const Vector<U, 3>& v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
  explicit Vector(const Vector<T, 4>& v) : x(v.x), y(v.y), z(v.z) {}
  T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  const T& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  template <int... I> auto swizzle() const { return Vector<T, sizeof...(I)>((*this)[I]...); }
};
template <class T> struct Vector<T, 4> {
  union { T x{}; T r, s; }; union { T y{}; T g, t; };
  union { T z{}; T b, p; }; union { T w{}; T a, q; };
  Vector() = default;
  explicit Vector(T s) : x(s), y(s), z(s), w(s) {}
  Vector(T a, T b, T c, T d) : x(a), y(b), z(c), w(d) {}
  Vector(const Vector<T, 3>& v, T d) : x(v.x), y(v.y), z(v.z), w(d) {}
  Vector(const Vector<T, 2>& a, const Vector<T, 2>& b) : x(a.x), y(a.y), z(b.x), w(b.y) {}
  template <class U> explicit Vector(const Vector<U, 4>& v) : x(T(v.x)), y(T(v.y)), z(T(v.z)), w(T(v.w)) {}
  T& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
  const T& operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
  template <int... I> auto swizzle() const { return Vector<T, sizeof...(I)>((*this)[I]...); }
};
using vec2 = Vector<double, 2>; using vec3 = Vector<double, 3>; using vec4 = Vector<double, 4>;
using dvec2 = vec2; using dvec3 = vec3; using dvec4 = vec4;
using ivec2 = Vector<int, 2>; using ivec3 = Vector<int, 3>; using ivec4 = Vector<int, 4>;
using uvec2 = Vector<uint, 2>; using uvec3 = Vector<uint, 3>; using uvec4 = Vector<uint, 4>;
#define SHADER_OPERATOR(op)                                                                      \
  template <class T, int N> Vector<T, N> operator op(const Vector<T, N>& a, const Vector<T, N>& b) { \
    Vector<T, N> r; for (int i = 0; i < N; ++i) r[i] = a[i] op b[i]; return r; }                  \
  template <class T, int N> Vector<T, N> operator op(const Vector<T, N>& a, std::type_identity_t<T> b) { \
    Vector<T, N> r; for (int i = 0; i < N; ++i) r[i] = a[i] op b; return r; }                     \
  template <class T, int N> Vector<T, N> operator op(std::type_identity_t<T> a, const Vector<T, N>& b) { \
    Vector<T, N> r; for (int i = 0; i < N; ++i) r[i] = a op b[i]; return r; }                     \
  template <class T, int N, class B> Vector<T, N>& operator op##=(Vector<T, N>& a, const B& b) { return a = a op b; }
SHADER_OPERATOR(+) SHADER_OPERATOR(-) SHADER_OPERATOR(*) SHADER_OPERATOR(/)
#undef SHADER_OPERATOR
template <class T, int N> Vector<T, N> operator-(const Vector<T, N>& a) { return T(0) - a; }
template <class T, int N> bool operator==(const Vector<T, N>& a, const Vector<T, N>& b) {
  for (int i = 0; i < N; ++i) if (!(a[i] == b[i])) return false;
  return true;
}
#define SHADER_FUNCTION1(name, expression)                             \
  inline double name(double x) { return expression; }                  \
  template <int N> Vector<double, N> name(const Vector<double, N>& v) { \
    Vector<double, N> r; for (int i = 0; i < N; ++i) r[i] = name(v[i]); return r; }
SHADER_FUNCTION1(sin, std::sin(x)) SHADER_FUNCTION1(cos, std::cos(x)) SHADER_FUNCTION1(tan, std::tan(x))
SHADER_FUNCTION1(asin, std::asin(x)) SHADER_FUNCTION1(acos, std::acos(x)) SHADER_FUNCTION1(atan, std::atan(x))
SHADER_FUNCTION1(sinh, std::sinh(x)) SHADER_FUNCTION1(cosh, std::cosh(x)) SHADER_FUNCTION1(tanh, std::tanh(x))
SHADER_FUNCTION1(exp, std::exp(x)) SHADER_FUNCTION1(exp2, std::exp2(x)) SHADER_FUNCTION1(log, std::log(x))
SHADER_FUNCTION1(log2, std::log2(x)) SHADER_FUNCTION1(sqrt, std::sqrt(x)) SHADER_FUNCTION1(inversesqrt, 1 / std::sqrt(x))
SHADER_FUNCTION1(floor, std::floor(x)) SHADER_FUNCTION1(ceil, std::ceil(x)) SHADER_FUNCTION1(trunc, std::trunc(x))
SHADER_FUNCTION1(round, std::nearbyint(x)) SHADER_FUNCTION1(roundEven, std::nearbyint(x)) SHADER_FUNCTION1(fract, x - std::floor(x))
SHADER_FUNCTION1(abs, std::fabs(x)) SHADER_FUNCTION1(sign, x > 0 ? 1.0 : x < 0 ? -1.0 : x)
SHADER_FUNCTION1(radians, x * (3.14159265358979323846 / 180)) SHADER_FUNCTION1(degrees, x * (180 / 3.14159265358979323846))
#undef SHADER_FUNCTION1
template <class T> requires std::same_as<T, int> T abs(T x) { return x < 0 ? -x : x; }
#define SHADER_FUNCTION2(name, expression)                                                        \
  inline double name(double a, double b) { return expression; }                                   \
  template <Integer T> T name(T a, T b) { return expression; }                                    \
  template <class T, int N> Vector<T, N> name(const Vector<T, N>& a, const Vector<T, N>& b) {     \
    Vector<T, N> r; for (int i = 0; i < N; ++i) r[i] = name(a[i], b[i]); return r; }              \
  template <class T, int N> Vector<T, N> name(const Vector<T, N>& a, std::type_identity_t<T> b) { \
    Vector<T, N> r; for (int i = 0; i < N; ++i) r[i] = name(a[i], b); return r; }
SHADER_FUNCTION2(min, b < a ? b : a) SHADER_FUNCTION2(max, a < b ? b : a)
SHADER_FUNCTION2(mod, a - b * std::floor(a / b)) SHADER_FUNCTION2(pow, std::pow(a, b))
#undef SHADER_FUNCTION2
inline double atan(double y, double x) { return std::atan2(y, x); }
inline double step(double edge, double x) { return x < edge ? 0 : 1; }
inline double fma(double a, double b, double c) { return std::fma(a, b, c); }
inline double clamp(double x, double low, double high) { return min(max(x, low), high); }
template <Integer T> T clamp(T x, T low, T high) { return min(max(x, low), high); }
template <class T, int N> Vector<T, N> clamp(const Vector<T, N>& v, std::type_identity_t<T> low, std::type_identity_t<T> high) { return min(max(v, low), high); }
template <class T, int N> Vector<T, N> clamp(const Vector<T, N>& v, const Vector<T, N>& low, const Vector<T, N>& high) { return min(max(v, low), high); }
inline double mix(double a, double b, double t) { return a * (1 - t) + b * t; }
template <int N> Vector<double, N> mix(const Vector<double, N>& a, const Vector<double, N>& b, double t) { return a * (1 - t) + b * t; }
template <int N> Vector<double, N> mix(const Vector<double, N>& a, const Vector<double, N>& b, const Vector<double, N>& t) { return a * (1.0 - t) + b * t; }
inline double smoothstep(double low, double high, double x) {
  const double t = clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}
template <int N> double dot(const Vector<double, N>& a, const Vector<double, N>& b) {
  double sum = 0;
  for (int i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}
template <int N> double length(const Vector<double, N>& v) { return std::sqrt(dot(v, v)); }
template <int N> double distance(const Vector<double, N>& a, const Vector<double, N>& b) { return length(a - b); }
template <int N> Vector<double, N> normalize(const Vector<double, N>& v) { return v / length(v); }
inline vec3 cross(const vec3& a, const vec3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
template <int N> Vector<double, N> reflect(const Vector<double, N>& d, const Vector<double, N>& n) { return d - n * (2 * dot(n, d)); }
template <int N> Vector<double, N> refract(const Vector<double, N>& d, const Vector<double, N>& n, double eta) {
  const double c = dot(n, d), k = 1 - eta * eta * (1 - c * c);
  return k < 0 ? Vector<double, N>(0.0) : d * eta - n * (eta * c + std::sqrt(k));
}
inline bool isnan(double x) { return std::isnan(x); }
inline bool isinf(double x) { return std::isinf(x); }
inline int floatBitsToInt(double x) { return std::bit_cast<int>(float(x)); }
inline uint floatBitsToUint(double x) { return std::bit_cast<uint>(float(x)); }
inline double intBitsToFloat(int x) { return std::bit_cast<float>(x); }
inline double uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }
}  // namespace shader
#define float double
#define precise
#define highp
#define mediump
#define lowp
namespace shader {
)prelude";
}

}  // namespace twintrace::probe
