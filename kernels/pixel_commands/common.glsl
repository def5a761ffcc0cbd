// What every pass binds or knows: the pixels' surfaces, the surfaces' slots, sizes that hold whatever the parameters say.
#include "harness/glsl/ports.glsl"
#include "kernels/pixel_commands/layout.h"
#include "harness/glsl/tiles.glsl"

PARAMS(CommandParams);

const uint kNoSurface = 0xffffffffu;     // of a pixel that nothing covers, or that another one's copy fills
const uint kWrongSurface = 0xfffffffeu;  // of a pixel whose surface index names none

const uint kMaterialBits = 12u;          // kMaxMaterials
const uint kKeyBits = 18u;               // kMaxShaders
const uint kUnlisted = 1u << kKeyBits;   // key of a surface without a visible shader or material, above all others
uint shader_of(uint key) { return key >> kMaterialBits & kMaxShaders - 1u; }
uint material_of(uint key) { return key & kMaxMaterials - 1u; }

uvec2 extent() { return uvec2(params.width, params.height); }
uint shader_slots() { return min(params.shaders, kMaxShaders); }
uint wave_log2() { return clamp(params.wave_log2, kSmallestWaveLog2, kLargestWaveLog2); }
uint wave_size() { return 1u << wave_log2(); }
uint waves_per_group_log2() { return min(params.waves_per_group_log2, kCommandBuckets - 1u); }
uint capacity() { return params.waves << wave_log2(); }  // entries
uint waves_of(uint pixels) { return (pixels + wave_size() - 1u) >> wave_log2(); }
uint entry_of(uvec2 pixel, uint copies) {
  return pixel.x | pixel.y << kEntryCoordinateBits | copies << kEntryCopyShift;
}
