#include <fmt/format.h>

#include <filesystem>

#include "common/import/imported_scene.h"

namespace twintrace {
namespace {

std::string text(const glm::vec3& v) {
  return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

/// A TOML basic string; control characters don't occur in names.
std::string text(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

void line(std::string& out, std::string_view key, const std::string& value) {
  out.append(key).append(" = ").append(value).append("\n");
}

/// Black is the default.
void colorLine(std::string& out, std::string_view key, const glm::vec3& color) {
  if (color != glm::vec3(0.0f)) line(out, key, text(color));
}

void addCamera(std::string& out, const ImportedScene& scene) {
  out += fmt::format("\n[film]\nwidth = {}\nheight = {}\n\n[camera]\n", scene.width, scene.height);
  line(out, "eye", text(scene.camera.eye));
  line(out, "target", text(scene.camera.target));
  line(out, "up", text(scene.camera.up));
  line(out, "fov", fmt::format("{}", scene.camera.fov));
  if (!scene.integrator.empty()) {
    out += fmt::format("\n[render]\nintegrator = {}\n", text(scene.integrator));
  }
  if (scene.background != glm::vec3(0.0f)) {
    out += fmt::format("\n[environment]\nradiance = {}\n", text(scene.background));
  }
}

void addMaterial(std::string& out, const Material& material) {
  out += fmt::format("\n[materials.{}]\n", text(material.name));
  colorLine(out, "albedo", material.albedo);
  colorLine(out, "specular", material.specular);
  if (material.specular != glm::vec3(0.0f)) {
    line(out, "roughness", fmt::format("{}", material.roughness));
    line(out, "lobe", text(std::string(material.lobe == Lobe::ggx ? "ggx" : "phong")));
  }
  colorLine(out, "emission", material.emission);
  colorLine(out, "ambient", material.ambient);
  colorLine(out, "highlight", material.highlight);
  if (material.highlight != glm::vec3(0.0f)) {
    line(out, "exponent", fmt::format("{}", material.exponent));
  }
}

void addObject(std::string& out, const ImportedPart& part, const std::string& file) {
  out += "\n[[objects]]\n";
  line(out, "name", text(part.material.name));
  line(out, "shape", text(std::string("mesh")));
  line(out, "file", text(file));
  line(out, "part", fmt::format("{}", part.number));
  if (part.smooth) line(out, "smooth", "true");
  line(out, "material", text(part.material.name));
}

void addLight(std::string& out, const PointLight& light) {
  line(out, "kind", text(std::string("point")));
  line(out, "position", text(light.position));
  line(out, "intensity", text(light.intensity));
}

void addLight(std::string& out, const SphereLight& light) {
  line(out, "kind", text(std::string("sphere")));
  line(out, "position", text(light.position));
  line(out, "radius", fmt::format("{}", light.radius));
  line(out, "intensity", text(light.intensity));
}

void addLight(std::string& out, const SunLight& light) {
  line(out, "kind", text(std::string("sun")));
  line(out, "direction", text(light.direction));
  line(out, "irradiance", text(light.irradiance));
  if (light.angle > 0.0f) line(out, "angle", fmt::format("{}", light.angle));
}

}  // namespace

std::string sceneText(const ImportedScene& scene, const std::string& folder) {
  const std::filesystem::path base = folder.empty() ? "." : folder;
  const std::string file = std::filesystem::proximate(scene.file, base).string();
  std::string out = fmt::format("# From {} by `twintrace import`.\n",
                                std::filesystem::path(scene.file).filename().string());
  for (const std::string& note : scene.notes) out += "# " + note + "\n";
  addCamera(out, scene);
  for (const ImportedPart& part : scene.parts) addMaterial(out, part.material);
  for (const ImportedPart& part : scene.parts) addObject(out, part, file);
  for (const Light& light : scene.lights) {
    out += "\n[[lights]]\n";
    std::visit([&](const auto& kind) { addLight(out, kind); }, light);
  }
  return out;
}

}  // namespace twintrace
