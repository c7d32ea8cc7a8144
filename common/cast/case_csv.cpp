#include "common/cast/case_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

#include "common/base/wording.h"
#include "common/cast/csv_rows.h"
#include "common/cast/rays_csv.h"

namespace twintrace {
namespace {

struct Record {
  std::string_view word;
  CaseKind kind;
  std::string_view form;
};

constexpr std::array<Record, 5> kPrimitives = {{
    {"sphere", CaseKind::sphere, "sphere,ID,cx,cy,cz,r"},
    {"box", CaseKind::box, "box,ID,xmin,ymin,zmin,xmax,ymax,zmax"},
    {"obb", CaseKind::orientedBox, "obb,ID, centre, three axes and three half sizes: 17 values"},
    {"plane", CaseKind::plane, "plane,ID,nx,ny,nz,px,py,pz"},
    {"tri", CaseKind::triangle, "tri,ID, three vertices: 11 values"},
}};
constexpr std::size_t kRayNumbers = 8;
constexpr std::string_view kRayForm = "ray,ID,ox,oy,oz,dx,dy,dz,tmin,tmax";

using Lines = std::map<std::string, int, std::less<>>;

/// Reads the records of one file in their order.
class CaseReader {
 public:
  explicit CaseReader(const std::string& path) : faults_(path) {}

  void read(const CsvRow& row) {
    const std::string_view word = row.fields.front().text;
    if (word == "scene") return readScene(row);
    if (word == "ray") return readRay(row);
    for (const Record& record : kPrimitives) {
      if (word == record.word) return readPrimitive(row, record);
    }
    refuse(row);
  }

  CasesFile finish() {
    faults_.throwIfAny();
    return std::move(file_);
  }

 private:
  void refuse(const CsvRow& row) {
    std::vector<std::string> words = {"scene"};
    for (const Record& record : kPrimitives) words.emplace_back(record.word);
    words.emplace_back("ray");
    const CsvField& field = row.fields.front();
    faults_.add(row.line, field.column, quote(field.text),
                oneOf(words) + didYouMean(field.text, words));
  }

  bool hasForm(const CsvRow& row, std::size_t count, std::string_view form) {
    if (row.fields.size() == count) return true;
    faults_.add(row.line, row.fields.front().column, fmt::format("{} values", row.fields.size()),
                form);
    return false;
  }

  /// The name in a row's second field, once in `taken`.
  std::string readName(const CsvRow& row, Lines& taken) {
    const CsvField& field = row.fields[1];
    if (field.text.empty()) {
      faults_.add(row.line, field.column, "nothing", "a name");
      return {};
    }
    const auto [place, isNew] = taken.emplace(field.text, row.line);
    if (!isNew) {
      faults_.add(row.line, field.column,
                  fmt::format("{} as in line {}", quote(field.text), place->second),
                  "a name of its own");
    }
    return std::string(field.text);
  }

  void readScene(const CsvRow& row) {
    beginScene(hasForm(row, 2, "scene,NAME") ? readName(row, sceneLines_) : "");
  }

  void beginScene(std::string name) {
    file_.cases.scenes.push_back({static_cast<std::uint32_t>(file_.cases.primitives.size()), 0});
    file_.cases.sceneNames.push_back(std::move(name));
    primitiveLines_.clear();
    rayLines_.clear();
  }

  CaseScene& scene() {
    if (file_.cases.scenes.empty()) beginScene({});
    return file_.cases.scenes.back();
  }

  void readPrimitive(const CsvRow& row, const Record& record) {
    const auto count = static_cast<std::size_t>(valueCount(record.kind));
    if (!hasForm(row, count + 2, record.form)) return;
    CaseScene& current = scene();
    if (!rayLines_.empty()) {
      faults_.add(row.line, row.fields.front().column, "a primitive after a ray",
                  "a scene's primitives before its rays");
    }
    file_.cases.primitiveNames.push_back(readName(row, primitiveLines_));
    CasePrimitive primitive{record.kind, {}};
    for (std::size_t i = 0; i < count; ++i) {
      primitive.values[i] = finiteNumber(row.line, row.fields[i + 2]);
    }
    file_.cases.primitives.push_back(normalised(primitive));
    ++current.count;
  }

  float finiteNumber(int line, const CsvField& field) {
    const float value = faults_.number(line, field);
    if (!std::isfinite(value)) {
      faults_.add(line, field.column, quote(field.text), "a finite number in float32");
    }
    return value;
  }

  void readRay(const CsvRow& row) {
    if (!hasForm(row, kRayNumbers + 2, kRayForm)) return;
    scene();
    file_.cases.rayNames.push_back(readName(row, rayLines_));
    std::array<float, kRayNumbers> v;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = faults_.number(row.line, row.fields[i + 2]);
    const auto index = static_cast<std::uint32_t>(file_.cases.scenes.size() - 1);
    file_.cases.rays.push_back({{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6], v[7]}, index});
    if (std::any_of(v.begin(), v.end(), [](float x) { return std::isnan(x); })) ++file_.nanRays;
  }

  CasesFile file_;
  CsvFaults faults_;
  Lines sceneLines_;
  Lines primitiveLines_;  // of the current scene, as rayLines_
  Lines rayLines_;
};

std::string nameOr(const std::vector<std::string>& names, std::size_t place, std::size_t index) {
  return names.empty() ? std::to_string(index) : names[place];
}

/// The name without what would end a field or begin a comment.
std::string writable(std::string name) {
  for (char& c : name) {
    if (c == ',' || c == '#' || static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
  }
  return name;
}

std::string_view wordOf(CaseKind kind) {
  return kPrimitives[static_cast<std::size_t>(kind)].word;
}

void writeNumbers(std::ostream& out, std::span<const float> numbers) {
  for (const float number : numbers) out << ',' << hexFloat(number);
  out << '\n';
}

void writeScene(std::ostream& out, const CaseSet& cases, std::size_t index) {
  const std::string name = writable(sceneName(cases, index));
  if (!name.empty()) out << "scene," << name << '\n';
  const CaseScene& scene = cases.scenes[index];
  for (std::uint32_t i = 0; i < scene.count; ++i) {
    const CasePrimitive& primitive = cases.primitives[scene.first + i];
    out << wordOf(primitive.kind) << ','
        << writable(nameOr(cases.primitiveNames, scene.first + i, i));
    const auto count = static_cast<std::size_t>(valueCount(primitive.kind));
    writeNumbers(out, std::span(primitive.values).first(count));
  }
}

void writeRay(std::ostream& out, const CastRay& ray, const std::string& name) {
  const std::array<float, kRayNumbers> numbers = {ray.origin.x,    ray.origin.y,    ray.origin.z,
                                                  ray.direction.x, ray.direction.y, ray.direction.z,
                                                  ray.tmin,        ray.tmax};
  out << "ray," << writable(name);
  writeNumbers(out, numbers);
}

/// Indices of each scene's rays.
std::vector<std::vector<std::size_t>> raysByScene(const CaseSet& cases) {
  std::vector<std::vector<std::size_t>> rays(cases.scenes.size());
  for (std::size_t i = 0; i < cases.rays.size(); ++i) rays[cases.rays[i].scene].push_back(i);
  return rays;
}

void copyScene(const CaseSet& from, std::size_t index, CaseSet& to) {
  const CaseScene& scene = from.scenes[index];
  to.scenes.push_back({static_cast<std::uint32_t>(to.primitives.size()), scene.count});
  to.sceneNames.push_back(sceneName(from, index));
  for (std::uint32_t i = 0; i < scene.count; ++i) {
    to.primitives.push_back(from.primitives[scene.first + i]);
    to.primitiveNames.push_back(nameOr(from.primitiveNames, scene.first + i, i));
  }
}

}  // namespace

CasesFile readCases(const std::string& path) {
  return parseCases(readCsvText(path), path);
}

CasesFile parseCases(std::string_view text, const std::string& path) {
  CaseReader reader(path);
  forEachCsvRow(text, [&](const CsvRow& row) { reader.read(row); });
  return reader.finish();
}

std::string sceneName(const CaseSet& cases, std::size_t scene) {
  return nameOr(cases.sceneNames, scene, scene);
}

std::string primitiveName(const CaseSet& cases, const CaseRay& ray, int primitive) {
  const auto index = static_cast<std::size_t>(primitive);
  return nameOr(cases.primitiveNames, cases.scenes[ray.scene].first + index, index);
}

std::string rayName(const CaseSet& cases, std::size_t ray) {
  return nameOr(cases.rayNames, ray, ray);
}

CaseSet selectRays(const CaseSet& cases, std::span<const std::size_t> rays) {
  CaseSet selected;
  std::map<std::uint32_t, std::uint32_t> scenes;  // there, and here
  for (const std::size_t i : rays) {
    CaseRay ray = cases.rays[i];
    const auto [place, isNew] =
        scenes.emplace(ray.scene, static_cast<std::uint32_t>(selected.scenes.size()));
    if (isNew) copyScene(cases, ray.scene, selected);
    ray.scene = place->second;
    selected.rays.push_back(ray);
    selected.rayNames.push_back(rayName(cases, i));
    if (!cases.bounces.empty()) selected.bounces.push_back(cases.bounces[i]);
  }
  return selected;
}

void writeCases(std::ostream& out, const CaseSet& cases) {
  const auto rays = raysByScene(cases);
  for (std::size_t scene = 0; scene < cases.scenes.size(); ++scene) {
    writeScene(out, cases, scene);
    for (const std::size_t ray : rays[scene]) {
      writeRay(out, cases.rays[ray].ray, rayName(cases, ray));
    }
  }
}

void writeCaseHitsHeader(std::ostream& out) {
  out << "scene,ray,engine,prim,t,nx,ny,nz,class\n";
}

void writeCaseHit(std::ostream& out, const CaseSet& cases, std::size_t ray, std::string_view engine,
                  const CaseAnswer& answer) {
  const CaseRay& asked = cases.rays[ray];
  const bool hit = answer.primitive >= 0;
  out << fmt::format("{},{},{},{},{},{}\n", csvField(sceneName(cases, asked.scene)),
                     csvField(rayName(cases, ray)), engine,
                     hit ? csvField(primitiveName(cases, asked, answer.primitive)) : "-1",
                     distanceAndNormal(hit, answer.t, answer.normal),
                     answer.clarity ? clarityName(*answer.clarity) : "");
}

std::string_view clarityName(Clarity clarity) {
  switch (clarity) {
    case Clarity::clean:
      return "clean";
    case Clarity::ambiguous:
      return "ambiguous";
    case Clarity::tie:
      return "tie";
  }
  return "";
}

}  // namespace twintrace
