// Record layout and named constants that the shaders and the C++ tracer read from this one text.
// Scene data is one array of 128-bit texels; floats are stored as their bit patterns.
#pragma once

// Texels per record.
const int kSphereTexels = 1;       // centre.xyz, radius
const int kBoxTexels = 2;          // minimum.xyz, -; maximum.xyz, -
const int kOrientedBoxTexels = 5;  // centre; axis x; axis y; axis z (unit); half size
const int kTriangleTexels = 3;     // a.xyz, smooth record + 1 (int) or 0; b.xyz, -; c.xyz, -
const int kSmoothTexels = 3;       // unit normals at a, b and c
const int kPlaneTexels = 2;        // point; normal (unit)
const int kInfoTexels = 1;         // emission of its material, material index (int)
const int kMaterialTexels = 7;     // scattering 0-2, reflectance 1-4, local shading 3, 5, 6
const int kLightTexels = 3;        // see fetchLight

// A primitive of a case: 12 of its values in the x, y and z of its texels; in their w its kind and the
// three others.
const int kCaseTexels = 4;
// A ray of a case: origin, tmin; direction, tmax; first texel of its primitives (int), their count
// (int), their largest coordinate, whether it bounces (int); the bounce's two random numbers.
const int kCaseRayTexels = 4;
// The answer: t, normal, primitive.
const int kCaseAnswerFloats = 5;

// Kinds of primitives in cases.
const int kCaseSphere = 0;
const int kCaseBox = 1;
const int kCaseOrientedBox = 2;
const int kCasePlane = 3;
const int kCaseTriangle = 4;

// A case's primitive when nothing was hit, and when the ray that should have bounced hit nothing.
const int kCaseMiss = -1;
const int kCaseNotStarted = -2;

// Lobe codes of a material's specular part.
const int kLobeNone = 0;
const int kLobeMirror = 1;
const int kLobeGgx = 2;
const int kLobePhong = 3;

// Light kinds.
const int kLightPoint = 0;
const int kLightSphere = 1;
const int kLightSun = 2;

// Integrators, as the host numbers them.
const int kIntegratorLocal = 0;
const int kIntegratorWhitted = 1;
const int kIntegratorReport = 2;
const int kIntegratorPath = 3;

// A hit's primitive when nothing was hit; larger than any index, so that a candidate at exactly the
// end of the ray's closed interval still wins the tie.
const int kNoPrimitive = 0x7fffffff;

// Random dimensions. A decision's counter is kCounterStride * bounce + dimension; no two decisions
// of a path share one, except in the report's estimator, on purpose.
const int kCounterStride = 8192;
const int kDimensionPixelX = 0;
const int kDimensionPixelY = 1;
const int kDimensionLensRadius = 2;
const int kDimensionLensAngle = 3;
const int kDimensionLobe = 4;
const int kDimensionDirectionU = 5;
const int kDimensionDirectionV = 6;
const int kDimensionLight = 16;  // light i uses the kDimensionsPerLight from 16 + 4 i on
const int kDimensionsPerLight = 4;
const int kMaxLights = 2000;  // so that a light's dimensions stay below kCounterStride
