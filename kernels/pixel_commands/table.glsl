// A tile's distinct surfaces in shared memory: an open hash table of as many slots as the tile has pixels, so that it
// cannot run over however many surfaces or materials the scene has, and a list of the slots in use.
// Loop turns of an invocation: at most 1024 probes for each of its pixels; at 32 threads 32,768 were every probe the
// longest.
layout(constant_id = 0) const uint THREADS = 64u;  // divides kTilePixels; 32 or more, and at most 32 pixels a thread
layout(local_size_x_id = 0) in;

const uint kPixelsPerThread = kTilePixels / THREADS;
const uint kSlotBits = 10u;  // kTilePixels slots
const uint kFree = 0xffffffffu;

shared uint surface_at[kTilePixels];  // a slot
shared uint pixels_at[kTilePixels];   // a slot; after group_surfaces() their place (tile_list.glsl)
shared uint used_slots[kTilePixels];  // the first `used` of them, in no order; group_surfaces() sorts them by key
shared uint used;

void clear_table() {
  for (uint i = gl_LocalInvocationID.x; i < kTilePixels; i += THREADS) {
    surface_at[i] = kFree;
    pixels_at[i] = 0u;
  }
  if (gl_LocalInvocationID.x == 0u) used = 0u;
  barrier();
}
