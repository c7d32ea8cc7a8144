#include "common/cast/case_texels.h"

#include <bit>

#include "common/scene/layout.h"
#include "tests/catch.h"
#include "tests/unit/cast/case_fixtures.h"

namespace twintrace {
namespace {

using test::primitiveOf;

TEST_CASE("packed cases hold the values of each primitive and its kind", "[cast][cases]") {
  CasePrimitive box{CaseKind::orientedBox, {}};
  for (std::size_t i = 0; i < box.values.size(); ++i) box.values[i] = static_cast<float>(i + 1);
  const CaseTexels packed = packCases(test::casesOf({box}, {}));
  REQUIRE(packed.texels.size() == layout::kCaseTexels);
  const auto at = [&](std::size_t texel, int component) {
    return std::bit_cast<float>(packed.texels[texel][component]);
  };
  for (int i = 0; i < 12; ++i)
    CHECK(at(static_cast<std::size_t>(i / 3), i % 3) == box.values[static_cast<std::size_t>(i)]);
  CHECK(packed.texels[0].w == layout::kCaseOrientedBox);
  for (std::size_t i = 1; i < 4; ++i) CHECK(at(i, 3) == box.values[11 + i]);
}

TEST_CASE("packed scenes know their texels and their reach", "[cast][cases]") {
  CaseSet cases;
  cases.primitives = {
      primitiveOf(CaseKind::sphere, {1, -7, 2, 3}),
      primitiveOf(CaseKind::plane, {100, 100, 100, 1, 2, -3}),
      primitiveOf(CaseKind::orientedBox, {1, 2, 3, 90, 0, 0, 0, 90, 0, 0, 0, 90, 4, 5, 6})};
  cases.scenes = {{0, 1}, {1, 1}, {2, 1}, {0, 3}, {3, 0}};
  const CaseTexels packed = packCases(cases);
  REQUIRE(packed.scenes.size() == 5);
  CHECK(packed.scenes[0].reach == 7.0f);
  CHECK(packed.scenes[1].reach == 3.0f);  // directions are no coordinates
  CHECK(packed.scenes[2].reach == 6.0f);
  CHECK(packed.scenes[3].reach == 7.0f);
  CHECK(packed.scenes[3].count == 3);
  CHECK(packed.scenes[2].firstTexel == 2 * layout::kCaseTexels);
  CHECK(packed.scenes[4].count == 0);
  CHECK(packed.scenes[4].reach == 0.0f);
}

}  // namespace
}  // namespace twintrace
