#version 460
// The block has another name than the port.
#include "harness/glsl/ports.glsl"
layout(local_size_x = 1) in;
struct Inner {
  vec2 place;
  uint kinds[3];
};
struct Item {
  uint key;
  vec3 normal;
  Inner inners[2];
  mat4 transform;
};
struct LayoutParams {
  uint count;
  float scale;
};
READS(0, Item, itemz);
READS(1, uvec4, words);  // four at a time, as a bare port may be read
WRITES(2, uint, results);
layout(binding = 3) uniform utexture2D picture;
layout(binding = 4, r32ui) uniform writeonly uimage2D stored;
PARAMS(LayoutParams);

void main() {
  const uint picked = texelFetch(picture, ivec2(0), 0).x;
  results[0] = itemz[0].inners[1].kinds[2] + words[0].w + params.count + picked;
  imageStore(stored, ivec2(0), uvec4(1));
}
