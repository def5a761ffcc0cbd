// Lights that a scene's file lacks, from a small JSON beside it:
//
//   {"about": "where they are from", "lights": [
//     {"kind": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "colour": [1, 0.8, 0.6], "intensity": 40,
//      "range": 8, "inner_deg": 20, "outer_deg": 35},
//     {"kind": "point", "position": [4, 2, 0], "intensity": 25}, {"kind": "directional", "direction": [0, -1, 1]}]}
//
// World coordinates; candela, or lux of a directional one; colours linear; angles from the axis, also as inner_rad and
// outer_rad. What is absent is as in KHR_lights_punctual: white, intensity 1, no limit of range, 0 and 45 degrees. A
// member that the kind does not have is an error, so that a slip of the pen is not silence.
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "harness/scene/json_file.h"
#include "harness/scene/scene.h"

namespace assay::scene {
namespace {

using Json = nlohmann::json;
constexpr double kRadiansADegree = 0.017453292519943295;

void require_members(const Json& object, const std::string& place, std::initializer_list<const char*> known) {
  for (const auto& [name, value] : object.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      refuse(place, fmt::format("has no member {}; there are {}", Json(name).dump(), fmt::join(known, ", ")));
}

double number(const Json& value, const std::string& place) {
  if (!value.is_number() || !(std::abs(value.get<double>()) < 1e30)) refuse(place, "is not a finite number");
  return value.get<double>();
}

std::optional<double> number(const Json& light, const std::string& place, const char* name) {
  if (!light.contains(name)) return {};
  return number(light[name], fmt::format("{}.{}", place, name));
}

std::optional<glm::dvec3> triple(const Json& light, const std::string& place, const char* name) {
  if (!light.contains(name)) return {};
  const Json& value = light[name];
  const std::string here = fmt::format("{}.{}", place, name);
  if (!value.is_array() || value.size() != 3) refuse(here, "is not three numbers");
  return glm::dvec3(number(value[0], here), number(value[1], here), number(value[2], here));
}

glm::dvec3 required(const Json& light, const std::string& place, const char* name) {
  const std::optional<glm::dvec3> value = triple(light, place, name);
  if (!value) refuse(place, fmt::format("{} is missing", name));
  return *value;
}

glm::vec3 direction(const Json& light, const std::string& place) {
  const glm::dvec3 v = required(light, place, "direction");
  if (!(length(v) > 1e-6)) refuse(place + ".direction", "has no length");
  return glm::vec3(normalize(v));
}

std::optional<double> angle_rad(const Json& light, const std::string& place, const std::string& name) {
  const std::optional<double> degrees = number(light, place, (name + "_deg").c_str()),
                              radians = number(light, place, (name + "_rad").c_str());
  if (degrees && radians) refuse(place, fmt::format("{} is given in degrees and in radians", name));
  return degrees ? *degrees * kRadiansADegree : radians;
}

LightKind kind_of(const Json& light, const std::string& place) {
  if (!light.contains("kind")) refuse(place, "kind is missing");
  const Json& kind = light["kind"];
  if (kind == "directional") return LightKind::directional;
  if (kind == "point") return LightKind::point;
  if (kind == "spot") return LightKind::spot;
  refuse(place + ".kind", fmt::format("{} is not directional, point or spot", kind.dump()));
}

Light light_of(const Json& json, const std::string& place) {
  if (!json.is_object()) refuse(place, "is not an object");
  Light light = {.kind = kind_of(json, place)};
  if (light.kind == LightKind::directional) {
    require_members(json, place, {"kind", "colour", "intensity", "direction"});
  } else if (light.kind == LightKind::point) {
    require_members(json, place, {"kind", "colour", "intensity", "position", "range"});
  } else {
    require_members(json, place,
                    {"kind", "colour", "intensity", "position", "range", "direction", "inner_deg", "inner_rad",
                     "outer_deg", "outer_rad"});
  }
  if (light.kind != LightKind::directional) light.position = required(json, place, "position");
  if (light.kind != LightKind::point) light.direction = direction(json, place);
  light.colour = glm::vec3(triple(json, place, "colour").value_or(glm::dvec3(1)));
  light.intensity = static_cast<float>(number(json, place, "intensity").value_or(1));
  light.range = static_cast<float>(number(json, place, "range").value_or(0));
  light.inner_rad = static_cast<float>(angle_rad(json, place, "inner").value_or(0));
  light.outer_rad = static_cast<float>(angle_rad(json, place, "outer").value_or(45 * kRadiansADegree));
  if (const std::string fault = fault_of(light); !fault.empty()) refuse(place, fault);
  return light;
}

}  // namespace

void append_sidecar(const std::filesystem::path& file, Scene& scene) {
  naming(file, [&] {
    const Json doc = parse_json(read_file(file));
    require_members(doc, "document", {"about", "lights"});
    if (!doc.contains("lights") || !doc["lights"].is_array()) refuse("lights", "is missing or not an array");
    for (size_t i = 0; i < doc["lights"].size(); ++i)
      scene.lights.push_back(light_of(doc["lights"][i], fmt::format("lights[{}]", i)));
    scene.notes.push_back(fmt::format("{} lights are from {}", doc["lights"].size(), file.filename().string()));
  });
}

}  // namespace assay::scene
