// For passes that know the features of their pixels: OR them into the tile masks while the frame goes on, with one atomic
// a subgroup and tile instead of one a pixel (Lazarek, Hammer 2025, with the OR over the matching lanes that its slide lacks).
// The includer declares the masks first: UPDATES(n, uint, masks); #define TILE_MASKS masks
#ifndef HARNESS_GLSL_TILE_OR
#define HARNESS_GLSL_TILE_OR
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_arithmetic : require

// Call it in subgroup-uniform control flow; a lane without a pixel passes bits = 0, and its tile is not looked at.
// One turn for each distinct tile of the subgroup: at most 128.
void or_into_tile(uint tile, uint bits) {
  uvec4 rest = subgroupBallot(bits != 0u);
  while (rest != uvec4(0u)) {
    const uint leader = subgroupBallotFindLSB(rest);
    const bool same = subgroupBroadcast(tile, leader) == tile;
#if defined(MUTANT_9001)  // the slide's form: the elected lane's bits stand for all
    const uint together = bits;
#elif defined(MUTANT_9002)  // lanes of other tiles join in
    const uint together = subgroupOr(bits);
#else
    const uint together = subgroupOr(same ? bits : 0u);
#endif
    if (gl_SubgroupInvocationID == leader) atomicOr(TILE_MASKS[tile], together);
#ifdef MUTANT_9003  // only the first tile of the subgroup is served
    rest = uvec4(0u);
#else
    rest &= ~subgroupBallot(same);
#endif
  }
}
#endif
