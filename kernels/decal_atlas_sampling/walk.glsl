// A thread walks a pixel's list: twice kMaxClusterEntries turns at most.
#include "kernels/decal_atlas_sampling/lists.glsl"

// The pixel's material under its decals; false where nothing is listed for it, so that nothing of it changes.
bool decals_walked(uvec2 pixel, out Material m) {
  const float d = depth_at(pixel);
  if (d == 0.0) return false;
  const List l = list_of(cell_of(params.grid, pixel, d));
  if (l.at == l.end) return false;  // of a pixel without decals nothing more is fetched, and nothing stored
  const Point p = point_at(pixel, d);
  m = load_material(pixel);
#ifdef MUTANT_15  // the last comes first
  for (uint i = l.end; i > l.at; --i) apply_decal(m, decal_of(entries[i - 1u]), p);
#else
  for (uint i = l.at; i < l.end; ++i) {
    while (i < l.end && !holds(decal_of(entries[i]), p)) ++i;
    if (i < l.end) apply_decal(m, decal_of(entries[i]), p);
  }
#endif
  return true;
}

void update_pixel(uvec2 pixel) {
  Material m;
  if (decals_walked(pixel, m)) store_material(pixel, m);
}
