#include "harness/kernel.h"

#include "kernels/attribute_interpolation/codes.h"
#include "kernels/attribute_interpolation/inputs.h"
#include "kernels/attribute_interpolation/oracle.h"
#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

namespace {

Groups per_pixel(const Case& c) { return {ceil_div(c.extent.width, 16), ceil_div(c.extent.height, 16), 1}; }
Count counted(uint AttributeParams::*member) {
  return [member](const Case& c) { return uint64_t{c.params<AttributeParams>().*member}; };
}

// A formula's shaders are <file>.comp, which packs, and <file>_floats.comp, which does not; `bound` says how far they
// may be.
struct FormulaVariant {
  const char* name;
  Formula bound;
  bool baseline;
  const char* note;
};
const FormulaVariant kFormulaVariants[] = {
    {"recentred_compensated", Formula::compensated, false, "relative to the pixel, products that lose nothing"},
    {"double_float", Formula::paired, false, "the same, in pairs of floats where ill-conditioned"},
    {"recentred", Formula::edges, false, "relative to the pixel by two edges, single multiply-adds"},
    {"ray_triangle", Formula::compensated, true, "three rays against the triangle"},
    {"perspective_divide", Formula::compensated, true, "projected, divided back, differenced at the next pixel"},
};

struct Encoding {
  uint value;
  const char* suffix;
  const char* note;
};
const Encoding kEncodings[] = {
    {kAttributesPacked, "", "unorm16, shared exponent, Lambert"},
    {kAttributesHalfScaled, "_half_scaled", "unorm16, binary16 of 64 d, Lambert"},
    {kAttributesHalves, "_halves", "the source's: binary16, derivatives below 2, xy"},
};

const char* const kReason = "exact value, running error of the formula, codes of both ends (README, Bounds)";

Bound packed_bound(const std::string& port, const Layout& fields, Bytes (*unpack)(std::span<const std::byte>, uint),
                   const FormulaVariant& f, uint encoding) {
  Bound b = between({port}, kReason);
  b.unpack = Unpack{fields, [=](std::span<const std::byte> from) { return unpack(from, encoding); }};
  b.answer = answer_name(port, name_of(f.bound), encoding);
  return b;
}

Variant packed_variant(const FormulaVariant& f, const Encoding& e) {
  return {.name = std::string(f.name) + e.suffix,
          .passes = {Dispatch{std::string(f.name) + ".comp", per_pixel}},
          .constants = {{"LAYOUT", {e.value}}},
          .bounds =
              std::vector{packed_bound("barycentrics", layout_of<BarycentricFields>(), unpack_barycentrics, f, e.value),
                          packed_bound("derivatives", layout_of<DerivativeFields>(), unpack_derivatives, f, e.value),
                          packed_bound("tangent_frame", layout_of<FrameFields>(), unpack_frame, f, e.value)},
          .baseline = f.baseline,
          .note = std::string(f.note) + "; " + e.note};
}

Bound plain_bound(const char* port, const FormulaVariant& f, uint encoding) {
  Bound b = between({port}, kReason);
  b.answer = answer_name(port, name_of(f.bound), encoding);
  return b;
}

// Every formula in every encoding, and unpacked, to judge the arithmetic apart; the default also as consumers read it.
std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const FormulaVariant& f : kFormulaVariants) {
    for (const Encoding& e : kEncodings) all.push_back(packed_variant(f, e));
    all.push_back({.name = std::string(f.name) + "_floats",
                   .passes = {Dispatch{std::string(f.name) + "_floats.comp", per_pixel}},
                   .bounds = std::vector{plain_bound("unpacked", f, 0)},
                   .baseline = f.baseline,
                   .note = std::string(f.note) + "; not packed, to judge the arithmetic"});
  }
  const FormulaVariant& f = kFormulaVariants[0];
  all[0].constants.push_back({"SPLIT_PRODUCTS", {0, 1}});
  for (const Encoding& e : kEncodings) {
    Variant v = packed_variant(f, e);
    v.name += "_decoded";
    v.passes.push_back(Dispatch{"decode.comp", per_pixel});
    v.bounds->push_back(plain_bound("decoded", f, e.value));
    v.note = "read back by harness/glsl/attributes.glsl";
    all.push_back(v);
  }
  return all;
}

Port only_in(Port p, std::string_view suffix, bool with) {
  for (const Variant& v : variants())
    if (v.name.ends_with(suffix) == with) p.only_in.push_back(v.name);
  return p;
}

std::vector<Mutant> mutants() {
  return {
      {"harness/glsl/interpolation/triangle.glsl", 9103, "the translation of the clip rows is left out", "patchwork"},
      {"harness/glsl/interpolation/triangle.glsl", 9104, "the pixel's corner for its centre", "patchwork"},
      {"harness/glsl/interpolation/shown.glsl", 9113, "no surface where only one word is all ones", "patchwork"},
      {"harness/glsl/interpolation/shown.glsl", 9114, "the instanced bit stays in the index", "patchwork"},
      {"harness/glsl/interpolation/shown.glsl", 9115, "the vertex offset is not added", "patchwork"},
      {"harness/glsl/interpolation/frame.glsl", 9111, "the normal is not turned round by a mirror", "patchwork"},
      {"harness/glsl/interpolation/frame.glsl", 9112, "normals by the transform, not its cofactors", "patchwork"},
      {"pack.glsl", 9, "handedness is not turned round by a mirror", "patchwork_flags"},
      {"pack.glsl", 20, "the first two weights instead of the last", "patchwork"},
      {"pack.glsl", 21, "derivatives transposed", "patchwork"},
      {"pack.glsl", 22, "facing without regard to a mirror", "patchwork"},
      {"pack.glsl", 23, "<= for < : a z of 0 is negative", "patchwork_flags"},
      {"harness/glsl/half.glsl", 9116, "truncates in place of rounding", "patchwork"},
      {"harness/glsl/interpolation/rescale.glsl", 9105, "coordinates are not scaled: products overflow",
       "powers_of_ten"},
      {"harness/glsl/interpolation/products.glsl", 9106, "what the product lost is not given back", "class_typical"},
      {"harness/glsl/interpolation/weigh.glsl", 9107, "weights below 0 stay", "outside_by_a_snap"},
      {"harness/glsl/interpolation/weigh.glsl", 9108, "a hit behind the eye has derivatives", "behind_the_eye"},
      {"harness/glsl/interpolation/weigh.glsl", 9109, "derivatives not times w", "class_typical"},
      {"harness/glsl/interpolation/weigh.glsl", 9110, "derivatives along y the other way round", "class_typical"},
      {"recentred.glsl", 15, "a sign of a derivative", "class_typical"},
      {"double_float.glsl", 16, "a pair's lower halves are not added", "class_sliver_1e-6_centre"},
      {"double_float.glsl", 17, "a cross term of a product is left out", "class_sliver_1e-6_centre"},
      {"double_float.glsl", 18, "pairs are never used", "class_sliver_1e-4_centre"},
      {"attributes.glsl", 9101, "derivatives transposed", "patchwork"},
      {"attributes.glsl", 9102, "the other side is seen", "patchwork"}};
}

// The visibility buffer and each vertex, index and record once; a pixel of each output once.
Cost cost(const Case& c) {
  const auto p = c.params<AttributeParams>();
  return {.bytes_read = pixels(c) * 8 + uint64_t{p.vertices} * (sizeof(vec3) + sizeof(VertexAttributes)) +
                        uint64_t{p.indices} * 4 + uint64_t{p.surfaces} * sizeof(SurfaceRecord) +
                        uint64_t{p.clip_samples} * sizeof(ClipSample),
          .bytes_written = pixels(c) * 20,
          .operations = pixels(c) * 200};
}

}  // namespace

Kernel describe() {
  return {
      .name = "attribute_interpolation",
      .source = "Lazarek, Hammer 2025, Deferred Attribute Interpolation",
      .default_variant = "recentred_compensated",
      .params = layout_of<AttributeParams>(),
      .ports = {reads_image("visibility", Format::rg32_uint, {"visibility.visibility"}),
                reads<vec3>("positions", counted(&AttributeParams::vertices), {"scene.positions"}),
                reads<VertexAttributes>("attributes", counted(&AttributeParams::vertices), {"scene.attributes"}),
                reads<uint>("indices", counted(&AttributeParams::indices), {"scene.indices"}),
                reads<SurfaceRecord>("surfaces", counted(&AttributeParams::surfaces), {"scene.surfaces"}),
                reads<ClipSample>("clip_samples", counted(&AttributeParams::clip_samples)),
                only_in(writes<uint>("barycentrics", pixels), "_floats", false),
                only_in(writes<uvec2>("derivatives", pixels), "_floats", false),
                only_in(writes<uvec2>("tangent_frame", pixels), "_floats", false),
                only_in(writes<UnpackedAttributes>("unpacked", pixels), "_floats", true),
                only_in(writes<DecodedAttributes>("decoded", pixels), "_decoded", true)},
      .variants = variants(),
      .oracle = interpolate,
      .inputs = inputs(),
      .bounds = {},
      .mutants = mutants(),
      .cost = cost,
      .typical = typical,
      .extents = {{256, 256}, {1920, 1080}, {3840, 2160}},
      .frame = frame,
      .undecided_limit = 2e-3,
      .undecided_reason = "slivers, and areas that single multiply-adds cannot tell (README, Bounds)",
      .errors = error_table(),
  };
}

}  // namespace assay::attribute_interpolation
