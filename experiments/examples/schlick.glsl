// Schlick's approximation of Fresnel reflectance, twice; the second has a mistake planted in it.
// See "Your own shader on trial" in the README.

// The reflectance at an angle of cosine `cosine` from the surface's normal, if it is `f0` there.
// twintrace: cosine in [0, 1], f0 in [0, 1]
float schlick(float cosine, float f0) {
  float m = clamp(1.0 - cosine, 0.0, 1.0);
  float m2 = m * m;
  return f0 + (1.0 - f0) * m2 * m2 * m;
}

// twintrace: cosine in [0, 1], f0 in [0, 1]
float schlickFast(float cosine, float f0) {
  float m = clamp(1.0 - cosine, 0.0, 1.0);
  float m2 = m * m;
  return f0 + (1.0 - f0) * m2 * m2;
}
