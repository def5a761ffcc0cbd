// Lights, decals and particles that a scene's file lacks, from a small JSON beside it:
//
//   {"about": "where they are from", "lights": [
//     {"kind": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "colour": [1, 0.8, 0.6], "intensity": 40,
//      "range": 8, "inner_deg": 20, "outer_deg": 35, "shadows": true},
//     {"kind": "point", "position": [4, 2, 0], "intensity": 25}, {"kind": "directional", "direction": [0, -1, 1]}],
//    "decals": [
//     {"position": [0, 1.5, -3], "outward": [0, 0, 1], "up": [0, 1, 0], "half_extents": [0.4, 0.6, 0.1],
//      "colour_image": "poster.png", "normal_image": "folds.png", "roughness_image": "gloss.png", "weights": [1, 1,
//      0.5], "fade_distance": 20, "normal_mode": "reoriented"},
//     {"position": [0, 0, 0], "outward": [0, 1, 0], "half_extents": [1, 1, 0.1], "colour": [0.1, 0.05, 0],
//      "coverage": 0.5, "roughness": 0.2, "weights": [1, 0, 1], "receiver": 3}],
//    "particles": [
//     {"kind": "smoke", "position": [0, 1, 0], "count": 80, "radius": 0.2, "height": 2.5, "opacity": 0.15,
//      "colour": [0.6, 0.6, 0.6], "half_extents": [0.1, 0, 0.1]},
//     {"kind": "dust", "position": [0, 2, 0], "half_extents": [3, 2, 3], "count": 300, "radius": 0.02}]}
//
// World coordinates; candela, or lux of a directional one; colours linear; angles from the axis, also as inner_rad and
// outer_rad. What is absent is as in KHR_lights_punctual: white, intensity 1, no limit of range, 0 and 45 degrees, no
// shadows. A member that the kind does not have is an error, so that a slip of the pen is not silence. Of decals
// position, outward and half_extents must be there; pictures are PNG files beside this one; the rest is as in scene.h.
// With a receiver, an instance by its number, the box is in its space. Of particles kind and position must be there;
// smoke begins within half_extents of its position and rises by its height, dust drifts about in there; the rest is as
// in scene.h (Emitter).
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>

#include "harness/image/image.h"
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
    require_members(json, place, {"kind", "colour", "intensity", "direction", "shadows"});
  } else if (light.kind == LightKind::point) {
    require_members(json, place, {"kind", "colour", "intensity", "position", "range", "shadows"});
  } else {
    require_members(json, place,
                    {"kind", "colour", "intensity", "position", "range", "direction", "inner_deg", "inner_rad",
                     "outer_deg", "outer_rad", "shadows"});
  }
  if (light.kind != LightKind::directional) light.position = required(json, place, "position");
  if (light.kind != LightKind::point) light.direction = direction(json, place);
  light.colour = glm::vec3(triple(json, place, "colour").value_or(glm::dvec3(1)));
  light.intensity = static_cast<float>(number(json, place, "intensity").value_or(1));
  light.range = static_cast<float>(number(json, place, "range").value_or(0));
  light.inner_rad = static_cast<float>(angle_rad(json, place, "inner").value_or(0));
  light.outer_rad = static_cast<float>(angle_rad(json, place, "outer").value_or(45 * kRadiansADegree));
  if (json.contains("shadows")) {
    if (!json["shadows"].is_boolean()) refuse(place + ".shadows", "is neither true nor false");
    light.casts_shadows = json["shadows"].get<bool>();
  }
  if (const std::string fault = fault_of(light); !fault.empty()) refuse(place, fault);
  return light;
}

// The box's axes: z outwards, y as near to `up` as that allows.
glm::dquat orientation_of(const Json& decal, const std::string& place) {
  const glm::dvec3 z(required(decal, place, "outward"));
  if (!(length(z) > 1e-6)) refuse(place + ".outward", "has no length");
  const bool is_level = std::abs(z.y) > 0.999 * length(z);
  const glm::dvec3 up = triple(decal, place, "up").value_or(is_level ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0));
  const glm::dvec3 x = cross(up, z);
  if (!(length(x) > 1e-6 * length(z))) refuse(place + ".up", "is along outward");
  return quat_cast(glm::dmat3(normalize(x), normalize(cross(z, x)), normalize(z)));
}

uint32_t normal_mode_of(const Json& decal, const std::string& place) {
  if (!decal.contains("normal_mode")) return kNormalWhiteout;
  const Json& mode = decal["normal_mode"];
  if (mode == "linear") return kNormalLinear;
  if (mode == "whiteout") return kNormalWhiteout;
  if (mode == "reoriented") return kNormalReoriented;
  refuse(place + ".normal_mode", fmt::format("{} is not linear, whiteout or reoriented", mode.dump()));
}

// Pictures beside the file, each read once.
struct Pictures {
  std::filesystem::path folder;
  Scene& scene;
  std::map<std::string, uint32_t> known = {};

  uint32_t operator()(const Json& decal, const std::string& place, const char* name) {
    if (!decal.contains(name)) return kNone;
    const std::string here = fmt::format("{}.{}", place, name);
    if (!decal[name].is_string()) refuse(here, "is no file's name");
    const auto file = decal[name].get<std::string>();
    if (const auto it = known.find(file); it != known.end()) return it->second;
    try {
      image::Rgba8 read = image::read_png(folder / file);
      scene.images.push_back({file, read.width, read.height, std::move(read.texels)});
    } catch (const std::exception& e) {
      refuse(here, e.what());
    }
    return known[file] = static_cast<uint32_t>(scene.images.size()) - 1;
  }
};

Decal decal_of(const Json& json, const std::string& place, Pictures& picture) {
  if (!json.is_object()) refuse(place, "is not an object");
  require_members(json, place,
                  {"position", "outward", "up", "half_extents", "colour_image", "normal_image", "roughness_image",
                   "colour", "coverage", "roughness", "weights", "fade_distance", "normal_mode", "receiver"});
  Decal d = {.centre = required(json, place, "position"),
             .orientation = orientation_of(json, place),
             .half_extents = required(json, place, "half_extents"),
             .colour_image = picture(json, place, "colour_image"),
             .normal_image = picture(json, place, "normal_image"),
             .roughness_image = picture(json, place, "roughness_image"),
             .normal_mode = normal_mode_of(json, place)};
  d.colour =
      glm::vec4(triple(json, place, "colour").value_or(glm::dvec3(1)), number(json, place, "coverage").value_or(1));
  d.roughness = static_cast<float>(number(json, place, "roughness").value_or(1));
  d.weights = glm::vec3(triple(json, place, "weights").value_or(glm::dvec3(d.weights)));
  d.fade_distance = static_cast<float>(number(json, place, "fade_distance").value_or(0));
  if (json.contains("receiver")) {
    if (!json["receiver"].is_number_unsigned()) refuse(place + ".receiver", "is no number of an instance");
    d.receiver = static_cast<uint32_t>(std::min<uint64_t>(json["receiver"].get<uint64_t>(), kNone - 1));
  }
  if (const std::string fault = fault_of(d, picture.scene); !fault.empty()) refuse(place, fault);
  return d;
}

Emitter emitter_of(const Json& json, const std::string& place, uint32_t seed) {
  if (!json.is_object()) refuse(place, "is not an object");
  if (!json.contains("kind")) refuse(place, "kind is missing");
  const bool smoke = json["kind"] == "smoke";
  if (!smoke && json["kind"] != "dust")
    refuse(place + ".kind", fmt::format("{} is not smoke or dust", json["kind"].dump()));
  if (smoke)
    require_members(json, place,
                    {"kind", "position", "half_extents", "count", "radius", "opacity", "colour", "height"});
  else
    require_members(json, place, {"kind", "position", "half_extents", "count", "radius", "opacity", "colour"});
  Emitter e = {.kind = smoke ? EmitterKind::smoke : EmitterKind::dust, .position = required(json, place, "position")};
  e.half_extents = triple(json, place, "half_extents").value_or(e.half_extents);
  if (json.contains("count")) {
    if (!json["count"].is_number_unsigned()) refuse(place + ".count", "is no whole number");
    e.count = static_cast<uint32_t>(std::min<uint64_t>(json["count"].get<uint64_t>(), kNone));
  }
  e.radius = static_cast<float>(number(json, place, "radius").value_or(e.radius));
  e.opacity = static_cast<float>(number(json, place, "opacity").value_or(e.opacity));
  e.height = static_cast<float>(number(json, place, "height").value_or(e.height));
  e.colour = glm::vec3(triple(json, place, "colour").value_or(glm::dvec3(e.colour)));
  e.seed = seed;
  if (const std::string fault = fault_of(e); !fault.empty()) refuse(place, fault);
  return e;
}

const Json& array_of(const Json& doc, const char* name) {
  static const Json none = Json::array();
  if (!doc.contains(name)) return none;
  if (!doc[name].is_array()) refuse(name, "is not an array");
  return doc[name];
}

}  // namespace

void append_sidecar(const std::filesystem::path& file, Scene& scene) {
  naming(file, [&] {
    const Json doc = parse_json(read_file(file));
    require_members(doc, "document", {"about", "lights", "decals", "particles"});
    if (!doc.contains("lights") && !doc.contains("decals") && !doc.contains("particles"))
      refuse("document", "has neither lights nor decals nor particles");
    const Json &lights = array_of(doc, "lights"), &decals = array_of(doc, "decals"),
               &emitters = array_of(doc, "particles");
    for (size_t i = 0; i < lights.size(); ++i)
      scene.lights.push_back(light_of(lights[i], fmt::format("lights[{}]", i)));
    Pictures picture = {file.parent_path(), scene};
    for (size_t i = 0; i < decals.size(); ++i)
      scene.decals.push_back(decal_of(decals[i], fmt::format("decals[{}]", i), picture));
    const size_t before = scene.particles.size();
    for (size_t i = 0; i < emitters.size(); ++i)
      add_particles(scene, emitter_of(emitters[i], fmt::format("particles[{}]", i), static_cast<uint32_t>(i)));
    for (const auto& [count, what] : {std::pair(lights.size(), "lights"), std::pair(decals.size(), "decals"),
                                      std::pair(scene.particles.size() - before, "particles")})
      if (count) scene.notes.push_back(fmt::format("{} {} are from {}", count, what, file.filename().string()));
  });
}

}  // namespace assay::scene
