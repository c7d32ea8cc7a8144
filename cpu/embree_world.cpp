#include "cpu/embree_world.h"

#include "cpu/kernel/scene_access.h"

namespace twintrace {
namespace {

constexpr unsigned kSpheres = 0;  // geometry numbers
constexpr unsigned kBoxes = 1;
constexpr unsigned kTriangles = 2;

glm::vec3 toGlm(const kernel::Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

kernel::SceneView viewOf(const FlatScene& scene) {
  return kernel::viewScene(scene, RenderOptions{}, nullptr);
}

}  // namespace

EmbreeWorld::EmbreeWorld(const FlatScene& scene, bool robust)
    : device_(openEmbreeDevice()), world_(makeEmbreeScene(device_, robust)) {
  addSpheres(scene);
  addBoxes(scene);
  addTriangles(scene);
  commitEmbreeScene(device_, world_);
}

void EmbreeWorld::addSpheres(const FlatScene& scene) {
  const kernel::SceneView view = viewOf(scene);
  std::vector<glm::vec4> points;
  for (int i = 0; view.effectSphere && i < view.index.sphereCount; ++i) {
    const kernel::Sphere<float> sphere = kernel::fetchSphere<float>(view, i);
    points.emplace_back(toGlm(sphere.center), sphere.radius);
  }
  attachSpheres(device_, world_, kSpheres, points);
}

void EmbreeWorld::addBoxes(const FlatScene& scene) {
  const kernel::SceneView view = viewOf(scene);
  EmbreeTriangles triangles;
  for (int i = 0; view.effectBox && i < view.index.boxCount; ++i) {
    const kernel::Box<float> box = kernel::fetchBox<float>(view, i);
    triangles.addBox(toGlm(box.minimum), toGlm(box.maximum));
  }
  firstBox_ = view.index.sphereCount + (view.effectBox ? 0 : view.index.boxCount);
  for (int i = 0; view.effectOrientedBox && i < view.index.orientedBoxCount; ++i) {
    const kernel::OrientedBox<float> box = kernel::fetchOrientedBox<float>(view, i);
    triangles.addOrientedBox(toGlm(box.center),
                             {toGlm(box.axisX), toGlm(box.axisY), toGlm(box.axisZ)},
                             toGlm(box.halfSize));
  }
  attachTriangles(device_, world_, kBoxes, triangles);
}

void EmbreeWorld::addTriangles(const FlatScene& scene) {
  const kernel::SceneView view = viewOf(scene);
  EmbreeTriangles triangles;
  for (int i = 0; view.effectTriangle && i < view.index.triangleCount; ++i) {
    const kernel::Triangle<float> triangle = kernel::fetchTriangle<float>(view, i);
    triangles.addTriangle(toGlm(triangle.a), toGlm(triangle.b), toGlm(triangle.c));
  }
  firstTriangle_ = view.index.boundedCount() - view.index.triangleCount;
  attachTriangles(device_, world_, kTriangles, triangles);
}

int EmbreeWorld::primitiveOf(const RTCHit& hit) const {
  const auto element = static_cast<int>(hit.primID);
  if (hit.geomID == kSpheres) return element;
  if (hit.geomID == kTriangles) return firstTriangle_ + element;
  return firstBox_ + element / kTrianglesPerBox;
}

}  // namespace twintrace
