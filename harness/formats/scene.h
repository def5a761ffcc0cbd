// What the gather hands to the first passes of a frame: one surface a drawn instance, merged vertices and indices.
#ifndef FORMATS_SCENE_H
#define FORMATS_SCENE_H
#include "harness/shared.h"
SHARED_FORMATS_BEGIN

// Bits of SurfaceRecord.flags and MaterialRecord.flags (formats/material.h).
SHARED_CONST uint kMaterialMasked = 1u;       // alpha below the cutoff is a hole
SHARED_CONST uint kMaterialDoubleSided = 2u;  // back faces are seen
SHARED_CONST uint kMaterialBlended = 4u;      // drawn by the forward pass, not in visibility
SHARED_CONST uint kSurfaceFlipped = 8u;       // the transform mirrors: clockwise triangles face the camera
SHARED_CONST uint kSurfaceInstanced = 16u;    // drawn with hardware instancing

// Draws come in buckets that differ in pipeline state: bucket = masked * 3 + facing.
SHARED_CONST uint kFacingCullBack = 0u;   // single-sided
SHARED_CONST uint kFacingCullFront = 1u;  // single-sided, mirrored
SHARED_CONST uint kFacingBoth = 2u;       // double-sided
SHARED_CONST uint kDrawBuckets = 6u;

// A drawn instance of a mesh part with one material. Rows give clip x, y and w as dot(row, vec4(position, 1)), rounded
// once from the double product (Vulkan clip space, y down); clip z is the near distance, constant: reversed depth with
// an infinite far plane, depth = near / w. World rows are relative to the camera, metres, y up.
struct SurfaceRecord {
  vec4 clip_x;
  vec4 clip_y;
  vec4 clip_w;
  vec4 world_x;
  vec4 world_y;
  vec4 world_z;
  uint material;
  uint flags;
  uint first_index;  // of its first triangle in the merged index buffer
  uint triangle_count;
  uint vertex_offset;  // added to every index
  uint mesh;
};

// glTF's attributes; a missing normal or tangent is derived by the loader, a missing UV is zero.
struct VertexAttributes {
  vec3 normal;
  vec4 tangent;  // w: handedness, +1 or -1
  vec2 uv;
};

// VkDrawIndexedIndirectCommand; first_instance is the index of the first surface.
struct DrawCommand {
  uint index_count;
  uint instance_count;
  uint first_index;
  uint vertex_offset;
  uint first_instance;
};

// VkDispatchIndirectCommand.
struct DispatchArgs {
  uint x;
  uint y;
  uint z;
};

// How much of each there is, and where each bucket of draws begins (the last entry is their end).
struct SceneCounts {
  uint vertices;
  uint indices;
  uint surfaces;
  uint materials;
  uint draws;
  uint bucket_first[kDrawBuckets + 1];
  uint lights;
  uint visible_shaders;    // shader classes that a gathered surface has
  uint visible_materials;  // materials that a gathered surface has
};

// Of a surface: its shader class and material among the visible ones, as the gather registered them (compact indices,
// ascending with the class and the material). kUnregistered names a class or material that was not registered.
struct SurfaceSlot {
  uint shader;
  uint material;
};
SHARED_CONST uint kUnregistered = 0xffffffffu;

#ifdef __cplusplus
SHARED_LAYOUT(SurfaceRecord, clip_x, clip_y, clip_w, world_x, world_y, world_z, material, flags, first_index,
              triangle_count, vertex_offset, mesh);
SHARED_LAYOUT(VertexAttributes, normal, tangent, uv);
SHARED_LAYOUT(DrawCommand, index_count, instance_count, first_index, vertex_offset, first_instance);
SHARED_LAYOUT(DispatchArgs, x, y, z);
SHARED_LAYOUT(SceneCounts, vertices, indices, surfaces, materials, draws, bucket_first, lights, visible_shaders,
              visible_materials);
SHARED_LAYOUT(SurfaceSlot, shader, material);
#endif
SHARED_END
#endif
