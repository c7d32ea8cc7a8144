#include "common/cast/rays_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "common/base/wording.h"
#include "common/cast/csv_rows.h"

namespace twintrace {
namespace {

constexpr std::array<std::string_view, 8> kColumns = {"ox", "oy", "oz",   "dx",
                                                      "dy", "dz", "tmin", "tmax"};
constexpr std::string_view kHeader = "the header ox,oy,oz,dx,dy,dz,tmin,tmax";

void checkHeader(const CsvRow& row, CsvFaults& faults) {
  for (std::size_t i = 0; i < row.fields.size() && i < kColumns.size(); ++i) {
    const CsvField& field = row.fields[i];
    if (field.text == kColumns[i]) continue;
    return faults.add(row.line, field.column, quote(field.text), kHeader);
  }
  if (row.fields.size() == kColumns.size()) return;
  faults.add(row.line, row.fields.front().column, fmt::format("{} columns", row.fields.size()),
             kHeader);
}

void addRay(const CsvRow& row, RaysFile& file, CsvFaults& faults) {
  if (row.fields.size() != kColumns.size()) {
    return faults.add(row.line, row.fields.front().column,
                      fmt::format("{} values", row.fields.size()),
                      "8 values, ox,oy,oz,dx,dy,dz,tmin,tmax");
  }
  std::array<float, kColumns.size()> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = faults.number(row.line, row.fields[i]);
  file.rays.push_back({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], v[7]});
  if (std::any_of(v.begin(), v.end(), [](float x) { return std::isnan(x); })) ++file.nanRays;
}

}  // namespace

RaysFile readRays(const std::string& path) {
  return parseRays(readCsvText(path), path);
}

RaysFile parseRays(std::string_view text, const std::string& path) {
  RaysFile file;
  CsvFaults faults(path);
  bool begun = false;
  forEachCsvRow(text, [&](const CsvRow& row) {
    if (begun) {
      addRay(row, file, faults);
    } else {
      checkHeader(row, faults);
    }
    begun = true;
  });
  if (!begun) faults.add(1, 1, "an empty file", kHeader);
  faults.throwIfAny();
  return file;
}

void writeRayHitsHeader(std::ostream& out) {
  out << "ray,engine,hit,object,primitive,t,nx,ny,nz\n";
}

void writeRayHit(std::ostream& out, std::size_t ray, std::string_view engine,
                 const RayAnswer& answer) {
  const bool hit = answer.primitive >= 0;
  out << fmt::format("{},{},{:d},{},{},{}\n", ray, engine, hit, hit ? csvField(answer.object) : "",
                     hit ? answer.primitive : -1, distanceAndNormal(hit, answer.t, answer.normal));
}

std::string distanceAndNormal(bool hit, double t, const glm::dvec3& normal) {
  if (!hit) return ",,,";
  return fmt::format("{},{},{},{}", hexFloat(t), hexFloat(normal.x), hexFloat(normal.y),
                     hexFloat(normal.z));
}

}  // namespace twintrace
