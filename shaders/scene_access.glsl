// The only reader of scene data: records out of the texel array, and the few uniforms of the scene.
// Counts and offsets (kSphereCount, kMaterialOffset, ...) come from the specialisation: constants,
// or uniforms in the program that serves every scene.
#pragma once

#include "number.glsl"
#include "records.glsl"

uvec4 fetchTexel(int index) {
  return texelFetch(sceneTexels, index);
}

vec3 floats3(uvec4 texel) {
  precise vec3 result =
      vec3(uintBitsToFloat(texel.x), uintBitsToFloat(texel.y), uintBitsToFloat(texel.z));
  return result;
}

float float4th(uvec4 texel) {
  precise float result = uintBitsToFloat(texel.w);
  return result;
}

Camera fetchCamera() {
  precise Camera result =
      Camera(cameraOrigin, cameraCorner, cameraStepX, cameraStepY, cameraLensX, cameraLensY);
  return result;
}

Sphere fetchSphere(int index) {
  uvec4 texel = fetchTexel(kSphereOffset + index * kSphereTexels);
  precise Sphere result = Sphere(floats3(texel), float4th(texel));
  return result;
}

Box fetchBox(int index) {
  int at = kBoxOffset + index * kBoxTexels;
  precise Box result = Box(floats3(fetchTexel(at)), floats3(fetchTexel(at + 1)));
  return result;
}

OrientedBox fetchOrientedBox(int index) {
  int at = kOrientedBoxOffset + index * kOrientedBoxTexels;
  precise OrientedBox result = OrientedBox(
      floats3(fetchTexel(at)), floats3(fetchTexel(at + 1)), floats3(fetchTexel(at + 2)),
      floats3(fetchTexel(at + 3)), floats3(fetchTexel(at + 4)));
  return result;
}

Triangle fetchTriangle(int index) {
  int at = kTriangleOffset + index * kTriangleTexels;
  precise Triangle result =
      Triangle(floats3(fetchTexel(at)), floats3(fetchTexel(at + 1)), floats3(fetchTexel(at + 2)));
  return result;
}

// Which record of normals a triangle has; below 0 for a flat one.
int fetchSmoothIndex(int triangle) {
  return int(fetchTexel(kTriangleOffset + triangle * kTriangleTexels).w) - 1;
}

// The unit normals at a triangle's vertices, as a triangle.
Triangle fetchNormals(int index) {
  int at = kSmoothOffset + index * kSmoothTexels;
  precise Triangle result =
      Triangle(floats3(fetchTexel(at)), floats3(fetchTexel(at + 1)), floats3(fetchTexel(at + 2)));
  return result;
}

Plane fetchPlane(int index) {
  int at = kPlaneOffset + index * kPlaneTexels;
  precise Plane result = Plane(floats3(fetchTexel(at)), floats3(fetchTexel(at + 1)));
  return result;
}

PrimitiveInfo fetchPrimitiveInfo(int primitive) {
  uvec4 texel = fetchTexel(kInfoOffset + primitive * kInfoTexels);
  precise PrimitiveInfo result = PrimitiveInfo(floats3(texel), int(texel.w));
  return result;
}

Scattering fetchScattering(int material) {
  int at = kMaterialOffset + material * kMaterialTexels;
  uvec4 diffuse = fetchTexel(at);
  uvec4 specular = fetchTexel(at + 1);
  precise vec3 lobe = floats3(fetchTexel(at + 2));
  precise Scattering result =
      Scattering(floats3(diffuse), floats3(specular), float4th(diffuse), lobe.x, lobe.y, lobe.z,
                 int(specular.w));
  return result;
}

Reflectance fetchReflectance(int material) {
  int at = kMaterialOffset + material * kMaterialTexels;
  uvec4 lobe = fetchTexel(at + 2);
  precise Reflectance result = Reflectance(
      floats3(fetchTexel(at + 3)), floats3(fetchTexel(at + 4)), floats3(lobe).x, float4th(lobe),
      int(fetchTexel(at + 1).w));
  return result;
}

LocalShading fetchLocalShading(int material) {
  int at = kMaterialOffset + material * kMaterialTexels;
  uvec4 highlight = fetchTexel(at + 6);
  precise LocalShading result =
      LocalShading(floats3(fetchTexel(at + 3)), floats3(highlight), float4th(highlight),
                   floats3(fetchTexel(at + 5)));
  return result;
}

Light fetchLight(int index) {
  int at = kLightOffset + index * kLightTexels;
  uvec4 first = fetchTexel(at);
  uvec4 second = fetchTexel(at + 1);
  uvec4 third = fetchTexel(at + 2);
  precise Light result = Light(int(third.x), floats3(first), float4th(first), floats3(second),
                               float4th(second));
  return result;
}

vec3 fetchEnvironmentRadiance() {
  precise vec3 result = environmentRadiance;
  return result;
}

float fetchEnvironmentTurn() {
  precise float result = environmentTurn;
  return result;
}

vec3 fetchEnvironmentPixel(int x, int y) {
  precise vec3 result = floats3(fetchTexel(kEnvironmentOffset + y * kEnvironmentWidth + x));
  return result;
}
