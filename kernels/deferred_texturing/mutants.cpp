#include "kernels/deferred_texturing/inputs.h"

namespace assay::deferred_texturing {

std::vector<Mutant> mutants() {
  return {
      {"common.glsl", 1, "the last column is left out", "one_pixel"},
      {"common.glsl", 2, "the instanced flag counts as part of the surface", "flags"},
      {"common.glsl", 3, "one surface too many, the last again", "surface_out_of_range"},
      {"footprint.glsl", 5, "all meshes begin at the first vertex", "flags"},
      {"footprint.glsl", 6, "only the way across is minified", "gradient_of_y"},
      {"footprint.glsl", 7, "the third vertex counts as the second", "magnified"},
      {"classes.glsl", 8, "metallic and roughness change places", "class_opaque"},
      {"classes.glsl", 9, "the strength of occlusion is a factor", "class_opaque"},
      {"classes.glsl", 10, "a normal's z is scaled too", "normal_scaled"},
      {"classes.glsl", 11, "the detail's scale is forgotten", "detail_scale"},
      {"classes.glsl", 12, "heights do not count", "layers_by_height"},
      {"classes.glsl", 13, "the lower layer on top", "layers_by_mask"},
      {"classes.glsl", 14, "one layer too many", "layer_past_end"},
      {"classes.glsl", 15, "emission without its detail", "class_emissive_detail"},
      {"classes.glsl", 16, "threads are rough and gaps smooth", "class_cloth"},
      {"classes.glsl", 17, "the thickness of metal", "class_skin"},
      {"classes.glsl", 18, "metal has pores", "class_wet_metal"},
      {"classes.glsl", 19, "water does not smooth", "class_wet"},
      {"classes.glsl", 20, "all instances have one tint", "class_foliage"},
      {"shade.glsl", 21, "masked materials need the flag", "class_masked"},
      {"shade.glsl", 22, "back faces are turned that should not be", "back_faces_kept"},
      {"shade.glsl", 23, "mirrored UVs have no hand", "back_faces_turned"},
      {"shade.glsl", 24, "a normal that is lost is no number", "normal_lost"},
      {"listed.glsl", 25, "all waves are taken for uniform", "one_material"},
      {"listed.glsl", 26, "another class's pixels are textured as this one's", "stale_entries"},
      {"listed.glsl", 27, "copies go right and down, not to the quad", "copies"},
      {"listed.glsl", 28, "a copy beyond the edge lands in the next row", "copies"},
      {"harness/glsl/gbuffer.glsl", 9301, "normals of the lower half are not folded", "class_opaque"},
      {"harness/glsl/gbuffer.glsl", 9303, "emission is truncated", "emissive_rounded"},
      {"harness/glsl/gbuffer.glsl", 9305, "base colour without its root", "class_opaque"},
      {"attributes.glsl", 30, "the first vertex's frame for all of the triangle", "mesh_curved"},
      {"attributes.glsl", 31, "a mirror does not turn the handedness", "back_faces_turned"},
      {"attributes.glsl", 32, "facing without regard to a mirror", "back_faces_turned"},
      {"attributes.glsl", 33, "the way down changes as the way across does", "gradient_of_y"},
      {"harness/glsl/interpolation/triangle.glsl", 9103, "the translation of the clip rows is left out",
       "mesh_in_perspective"},
      {"harness/glsl/interpolation/triangle.glsl", 9104, "the pixel's corner for its centre", "mesh_in_perspective"},
      {"harness/glsl/interpolation/weigh.glsl", 9107, "weights below 0 stay", "mesh_beside_the_pixel"},
      {"harness/glsl/interpolation/weigh.glsl", 9109, "derivatives not times w", "mesh_near_and_far"},
      {"harness/glsl/interpolation/frame.glsl", 9112, "normals by the transform, not its cofactors", "mesh_curved"},
      {"background.comp", 29, "only the sky is background", "surface_out_of_range"},
  };
}

}  // namespace assay::deferred_texturing
