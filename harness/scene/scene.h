// A scene as the renderer sees it, whatever file or code it came from. World: metres, right-handed, y up (glTF).
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/formats/clusters.h"
#include "harness/formats/decal.h"
#include "harness/formats/features.h"
#include "harness/formats/light.h"
#include "harness/formats/material.h"
#include "harness/formats/particle.h"
#include "harness/formats/scene.h"
#include "harness/formats/shadow.h"
#include "harness/kernel.h"

namespace assay::scene {

constexpr uint32_t kNone = 0xffffffffu;

struct Image {  // RGBA8, rows top to bottom
  std::string name;
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

enum class AlphaMode { opaque, masked, blended };

struct Material {
  std::string name;
  glm::vec4 base_colour = {1, 1, 1, 1};  // linear
  float metallic = 1, roughness = 1;
  glm::vec3 emissive = {0, 0, 0};
  uint32_t base_image = kNone, normal_image = kNone, metallic_roughness_image = kNone, occlusion_image = kNone,
           emissive_image = kNone;
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  uint32_t features = 0;  // beyond those that follow from the rest
  float normal_scale = 1, occlusion_strength = 1;
  std::optional<uint32_t> shader = {};  // kShader... of formats/material.h; else by shader_class's rules
  uint32_t layer = kNone;               // two-layer: the material on top
  uint32_t mask_image = kNone;          // linear, R
  float blend_depth = 0.1f;             // two-layer: the difference of heights over which the layers mix, above 0
  uint32_t detail_image = kNone;        // linear, RGB
  float detail_scale = 1;
};

struct Part {  // triangles of one material
  uint32_t first_index = 0, index_count = 0, material = 0;
};
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<uint32_t> indices;
  std::vector<Part> parts;
};
// To and fro about where a thing is at first: by `reach` and back, and by `turn_rad` about the vertical through it,
// both with the sine of time. A decal moves with its receiver.
struct Motion {
  glm::dvec3 reach = {};  // metres
  double turn_rad = 0;
  double period_s = 1;
};
struct Instance {
  uint32_t mesh = 0;
  glm::dmat4 to_world = glm::dmat4(1);
  Motion motion = {};
};

enum class LightKind { directional, point, spot };
// KHR_lights_punctual: candela (of a spot too, whatever its cone), or lux for directional; range 0 is unlimited. Cones
// are half angles, 0 <= inner <= outer <= pi/2.
struct Light {
  LightKind kind = LightKind::point;
  glm::dvec3 position = {};
  glm::vec3 direction = {0, 0, -1}, colour = {1, 1, 1};
  float intensity = 1, range = 0, inner_rad = 0, outer_rad = 0.785398f;
  bool casts_shadows = false;
  Motion motion = {};
};
// What makes the light no light; empty if it is sound.
std::string fault_of(const Light&);
// A box whose pictures lie on all surfaces within: x of its own axes is to the right of the pictures, y up, z away from
// the surface that it is made for. Colour, coverage in its alpha, and normals and roughness; where there is no picture,
// a constant. Pictures of one decal are of one size. Normals are as glTF's, green up the picture.
struct Decal {
  glm::dvec3 centre = {};
  glm::dquat orientation = {1, 0, 0, 0};
  glm::dvec3 half_extents = {0.5, 0.5, 0.5};  // metres
  uint32_t colour_image = kNone, normal_image = kNone, roughness_image = kNone;
  glm::vec4 colour = {1, 1, 1, 1};  // linear
  float roughness = 1;
  glm::vec3 weights = {1, 0, 0};  // of base colour, normal and roughness, 0..1; 0: the surface keeps its own
  float fade_distance = 0;        // view depth where it is gone, metres; 0: never
  uint32_t normal_mode = kNormalWhiteout;
  uint32_t receiver = kNone;  // an instance, in whose space the box is then, and with which it moves
};
// A soft disc that faces the viewer.
struct Particle {
  glm::dvec3 centre = {};
  glm::dvec3 velocity = {};  // metres a second; it drifts so, and is longer along it
  float radius = 0.1f;       // metres
  glm::vec3 albedo = {1, 1, 1};
  float opacity = 0.5f, softness = 0.2f, quality = 1;  // as in formats/particle.h
  // It begins `age_s` before, grows from half its radius to one and a half while it fades in and out, and after
  // `life_s` begins again. 0: it stays as it is.
  double age_s = 0, life_s = 0;
};
// Particles out of one place: smoke rises from it and spreads; dust drifts about within a box.
enum class EmitterKind { smoke, dust };
struct Emitter {
  EmitterKind kind = EmitterKind::smoke;
  glm::dvec3 position = {};
  glm::dvec3 half_extents = {0.1, 0, 0.1};  // metres, of where particles begin
  uint32_t count = 50;
  float radius = 0.2f, opacity = 0.15f;
  glm::vec3 colour = {0.7f, 0.7f, 0.7f};
  float height = 2;  // that smoke rises, metres
  uint32_t seed = 0;
};
struct Camera {  // looks along -z of its own axes, x right, y up
  std::string name;
  glm::dvec3 eye = {};
  glm::dquat orientation = {1, 0, 0, 0};
  double vertical_fov_rad = 0.785398;
  double near_plane = 0.1;
};

struct Scene {
  std::string name;
  std::vector<Image> images;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Decal> decals;  // a later one lies over an earlier
  std::vector<Particle> particles;
  std::vector<Camera> cameras;
  std::vector<std::string> notes;  // what the file holds and was left out, a line each
};

// What makes the emitter none; empty if it is sound.
std::string fault_of(const Emitter&);
void add_particles(Scene&, const Emitter&);

// What makes the decal no decal of the scene; empty if it is sound.
std::string fault_of(const Decal&, const Scene&);

// A built-in name (bare, small, default) or a .gltf or .glb file, with what a sidecar adds (sidecar.cpp): the one
// given, else NAME.lights.json beside NAME.gltf or NAME.glb. Broken files throw std::runtime_error: file, place, what.
Scene load(const std::string& name_or_file, const std::filesystem::path& sidecar = {});
void append_sidecar(const std::filesystem::path&, Scene&);
Scene load_gltf(const std::filesystem::path&);
Scene bare();  // one triangle, one material
// A hall for the lit frame: large floors, carved columns with triangles of a pixel, foliage cards, 60 materials in the
// 8 shader classes, 300 lights, 1000 decals, 2000 particles. Its view shows each class on 2 % of its pixels at least.
Scene default_scene();
Scene small();  // CI: floor, columns, masked foliage cards, instances, a mirrored instance, a spot and a point light,
                // decals
// The file's first camera, or one that sees the whole scene from outside (from inside for an atrium such as Sponza's).
Camera default_camera(const Scene&);

// A camera at `eye` that sees `target` in the middle of its image, y up where the direction allows it.
Camera look_at(const glm::dvec3& eye, const glm::dvec3& target, double vertical_fov_rad);
// A sequence at 60 Hz, a pure function of the frame's number; frame 0 is as it was made. `to` is the scene that `from`
// is, or one that this moved before.
constexpr double kFrame_s = 1.0 / 60;
void move_to_frame(uint32_t frame, const Scene& from, Scene& to);
// Who looks from side to side while walking forth and back.
Camera camera_in_frame(const Camera&, uint32_t frame);

// Every bit of formats/features.h that a pixel of the material has (features.cpp has the rules).
uint32_t feature_bits(const Scene&, const Material&);

// The material's kShader... (features.cpp has the rules).
uint32_t shader_class(const Scene&, const Material&);

// Axis-aligned; empty (lowest above highest) until something is added.
struct Bounds {
  glm::dvec3 lowest = glm::dvec3(1e300), highest = glm::dvec3(-1e300);
  void add(const glm::dvec3& p) { lowest = min(lowest, p), highest = max(highest, p); }
  bool empty() const { return !(lowest.x <= highest.x); }
};
Bounds bounds_of(const Mesh&, const Part&);  // in the mesh's own coordinates
Bounds bounds_of(const Scene&);              // of the instances' transformed part boxes, world

// What the tiles of the shadow atlas hold, for the next frame: by light and view, where, and of what it was drawn (the
// view's rows, then of each caster its number and transform), so that a tile is drawn anew where that is not the same.
struct ShadowCache {
  struct Held {
    ShadowTile tile;
    std::vector<double> still, moving;
  };
  uint32_t width = 0, height = 0;
  std::map<uint32_t, Held> tiles;
};
struct ShadowStatistics {
  uint32_t lights = 0, views = 0;
  uint32_t still_drawn = 0, composed = 0;  // tiles drawn anew, and those that moving things were drawn into
  uint32_t put_off = 0;                    // whose moving things moved, but whose turn it is not
};

// What the first passes of a frame read. Transforms are camera-relative, the subtraction in double.
struct Gathered {
  SceneCounts counts = {};
  std::vector<glm::vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<uint32_t> indices;
  std::vector<SurfaceRecord> surfaces;
  std::vector<DrawCommand> draws;          // by bucket (formats/scene.h); instances of one mesh part are one command
  std::vector<MaterialRecord> materials;   // the scene's, textures only of those that surfaces show
  std::vector<SurfaceSlot> surface_slots;  // one a surface
  std::vector<uint32_t> shaders;           // classes of the surfaces' materials, ascending
  std::vector<LightRecord> lights;         // in the scene's order; a default where it has none
  ViewRays rays = {};
  ClusterGrid grid = {};
  std::vector<float> cluster_edges;  // slopes of columns and rows and depths of slices (kernels/cluster_voxelization)
  std::vector<float> slice_edges;    // the slices' in reversed depth
  std::vector<ClusterItem> cluster_items;  // view space; of each light, then of each decal
  std::vector<Texture> textures;           // one array a (size, format)
  DecalCounts decal_counts = {};
  std::vector<DecalRecord> decals;        // of those that reach the view, in the scene's order
  std::vector<ReceiverRecord> receivers;  // instances that they lie on
  std::vector<Texture> decal_atlas;       // none, or kAtlas...
  std::vector<uint32_t> light_source;     // of each light, its number in the scene; kNone: the default one
  ShadowCounts shadow_counts = {};
  ShadowCache shadow_cache = {};
  ShadowStatistics shadow_statistics = {};
  std::vector<ShadowView> shadow_views;
  std::vector<ShadowCaster> shadow_casters;
  std::vector<DrawCommand> shadow_draws;                     // in the ranges of formats/shadow.h
  std::vector<ShadowTile> shadow_still_tiles, shadow_tiles;  // to be drawn in this frame
  std::vector<ParticleRecord> particles;                     // the scene's, in its order
  std::vector<uint32_t> particle_order;                      // of those that are drawn, farthest first
  std::vector<uint32_t> surface_instance, surface_part;      // back to the scene, for reference renderers
  std::vector<std::string> notes;  // what was left out or added and why: culled instances and lights, …
};
// How shadows are drawn in a frame, and what the frame before left of them.
struct ShadowRequest {
  ShadowCache before = {};
  uint32_t frame = 0;
  bool sliced = true;  // tiles of lights that are small on the screen are composed in every second or fourth frame
};
// Without a request no light casts shadows.
Gathered gather(const Scene&, const Camera&, Extent, const ShadowRequest* shadows = nullptr);
// Adds the grid of cells of so many pixels, and the items of the lights and decals gathered. Every pixel that one of
// them reaches, as shaders compute positions, lies in a cell that its item touches.
constexpr uint32_t kClusterSlices = 24;
void append_clusters(const Camera&, Extent picture, Extent cell, uint32_t slices, Gathered&);

// Row-major clip rows of a camera: x, y, w of Vulkan clip space (y down) for camera-relative world coordinates.
struct ClipRows {
  glm::dvec4 x, y, w;
};
ClipRows clip_rows(const Camera&, Extent);
// Their inverse on pixels and depths (formats/light.h), computed in double and rounded once.
ViewRays view_rays(const Camera&, Extent);

}  // namespace assay::scene
