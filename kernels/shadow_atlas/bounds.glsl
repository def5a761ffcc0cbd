// The clip distances cut a caster at its tile's sides but for rounding, which grows with the caster's coordinates (README,
// "Nothing bleeds"): what it left beside the tile goes here.
layout(location = 0) flat in uvec4 bounds;

bool is_beside_tile() {
  uvec2 at = uvec2(gl_FragCoord.xy);
  return any(lessThan(at, bounds.xy)) || any(greaterThanEqual(at, bounds.zw));
}
