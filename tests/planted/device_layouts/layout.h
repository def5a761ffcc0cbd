// What the shaders of this folder get wrong, each in its own way.
#ifndef DEVICE_LAYOUTS_LAYOUT_H
#define DEVICE_LAYOUTS_LAYOUT_H
#include "harness/shared.h"
SHARED_BEGIN(device_layouts)

struct LayoutParams {
  uint count;
  float scale;
};
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

#ifdef __cplusplus
SHARED_LAYOUT(LayoutParams, count, scale);
SHARED_LAYOUT(Inner, place, kinds);
SHARED_LAYOUT(Item, key, normal, inners, transform);
#endif
SHARED_END
#endif
