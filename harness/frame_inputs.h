// What a frame tells the kernels that are chained in it.
#pragma once
#include <cstdint>
#include <vector>

#include "harness/formats/clusters.h"
#include "harness/formats/decal.h"
#include "harness/formats/light.h"
#include "harness/formats/particle.h"
#include "harness/formats/scene.h"
#include "harness/formats/shadow.h"
#include "harness/texture.h"

namespace assay {

struct Extent {  // pixels
  uint32_t width = 1, height = 1;
};

// What a frame leaves to the next of its shot, for variable rates.
struct FrameHistory {
  Extent extent = {};
  Bytes luma = {};     // rg8_unorm (formats/vrcs.h); empty: there is none
  float exposure = 0;  // what its radiance was multiplied by; 0: not known
  // Depths of the shadow atlas (formats/shadow.h), d32_float, all of it: of what is still, and of everything. Empty:
  // every tile is drawn anew.
  Bytes shadow_still = {}, shadow_depth = {};
  Bytes particle_rects = {};  // a word a particle (formats/particle.h); empty: none had light
};

// What the frame tells a kernel about the view that is drawn.
struct FrameInputs {
  Extent extent = {};
  SceneCounts scene = {};
  DecalCounts decals = {};
  ShadowCounts shadows = {};
  ParticleCounts particles = {};
  std::vector<uint32_t> shaders = {};  // visible shader classes (formats/material.h), ascending: slot -> class
  ViewRays rays = {};
  ClusterGrid grid = {};  // without cells: clusters are off
  float near_plane = 0.1f;
  vec3 ambient = vec3(0.03f, 0.035f, 0.04f);  // radiance that comes from everywhere
  float exposure_stops = 0;                   // added to the automatic exposure
  uint32_t frame = 0;                         // its number in a sequence
  bool vrcs = false;         // shading rates vary: passes shade primaries and copy (harness/formats/vrcs.h)
  float vrcs_tolerance = 0;  // error that is let pass, of luma 0..1
  // Share of the display's height that the picture has, as dynamic resolution chose it; 0: that is not known.
  float vrcs_resolution = 0;
  uint32_t vrcs_border = 0;   // pixels from a side within which twice that error passes
  FrameHistory history = {};  // luma is of this extent, or empty, and all rates are 1x1
  uint32_t view = 0;          // the debug view asked for (kernels/debug_view/layout.h)
};

}  // namespace assay
