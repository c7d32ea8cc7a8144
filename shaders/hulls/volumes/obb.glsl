// Oriented boxes, laid out as the primitive: center; three axes; half size.
#pragma once

#include "hulls/hull_access.glsl"

float enterObb(HullRay ray, int record) {
  precise OrientedBox box = OrientedBox(
      floats3(fetchHullTexel(record)), floats3(fetchHullTexel(record + 1)),
      floats3(fetchHullTexel(record + 2)), floats3(fetchHullTexel(record + 3)),
      floats3(fetchHullTexel(record + 4)));
  precise Ray local = toLocalRay(ray.ray, box);
  // Along a unit axis a point moves by up to sqrt(3) slacks, and is rounded again.
  precise float slack = 3.0f * ray.slack;
  precise SlabGroup axes = slabGroup(0, local, slack);
  precise Interval inside = withinSlabs(wholeRay(local), axes, -box.halfSize, box.halfSize);
  precise float result = entryOf(inside);
  return result;
}
