#include "kernels/depth_gradients/oracle.h"

#include "harness/half.h"
#include "harness/interpolation_oracle.h"
#include "harness/judged.h"

namespace assay::depth_gradients {

using namespace interpolation;

namespace {

constexpr uint64_t kSampledAbove = 1u << 16;  // pixels

struct Inputs {
  GradientParams params;
  std::span<const uvec2> visibility;
  std::span<const vec3> positions;
  std::span<const uint> indices;
  std::span<const SurfaceRecord> surfaces;
};
Inputs inputs_of(const Case& c) {
  return {c.params<GradientParams>(), c.input<uvec2>("visibility"), c.input<vec3>("positions"),
          c.input<uint>("indices"), c.input<SurfaceRecord>("surfaces")};
}

// What a pixel may hold: nothing; this, within rounding; or, where rounding hides which way the plane faces, anything.
struct Slope {
  enum class Is { nothing, known, anything } is = Is::nothing;
  Few<RoundedDouble, 2> gradient = {};
};

// Corners (x, y, w) relative to the pixel's centre, x and y in pixels times w. On the plane n . (x, y, w) = m the
// screen position is (s, t) = (x, y) / w, so 1/w = (n.x s + n.y t + n.z) / m: at the centre n.z / m, its gradient (n.x,
// n.y) / m.
Slope slope_at(const Inputs& in, uint64_t pixel) {
  std::optional<ShownTriangle> t = shown_triangle(in.visibility[pixel], in.positions, in.indices, in.surfaces);
  if (!t) return {};
  place(*t, uvec2(pixel % in.params.width, pixel / in.params.width), uvec2(in.params.width, in.params.height));
  const auto corners = scaled(*t);
  if (!corners) return {};
  const Recentred r = recentred_by_compensation(*t, *corners);
  if (reach(r.area) < double{kSmallestArea}) return {};
  if (!(magnitude(r.area.value) - r.area.error > double{kSmallestArea})) return {.is = Slope::Is::anything};
  Few<RoundedWide, 2> x, y, w;  // of the edges from the first corner
  for (int k = 0; k < 2; ++k) {
    x[k] = r.x[k + 1] - r.x[0], y[k] = r.y[k + 1] - r.y[0];
    w[k] = (*corners)[k + 1].w - (*corners)[0].w;
  }
  const RoundedWide inverse = reciprocal(r.area);
  return {.is = Slope::Is::known,
          .gradient = {narrowed(difference_of_products(y[0], w[1], w[0], y[1]) * inverse),
                       narrowed(difference_of_products(w[0], x[1], x[0], w[1]) * inverse)}};
}

// The half that is stored of a number, rounded to nearest, ties to even.
float stored(double v) {
  const double within = std::clamp(v, -double{kLargestGradient}, double{kLargestGradient}), step = half_step(within);
  return static_cast<float>(std::nearbyint(within / step) * step);
}

template <class T>
void append(Bytes& to, const T& v) {
  const auto* p = reinterpret_cast<const std::byte*>(&v);
  to.insert(to.end(), p, p + sizeof v);
}

// What is undetermined counts as two alternatives, so that it is told from what was judged.
void add(Expected& to, const Slope& s) {
  Gradient low = {}, high = {};
  for (int i = 0; i < 2; ++i) {
    if (s.is == Slope::Is::nothing) continue;
    const bool known = s.is == Slope::Is::known;
    low.gradient[i] = known ? stored(s.gradient[i].value - s.gradient[i].error) : -kLargestGradient;
    high.gradient[i] = known ? stored(s.gradient[i].value + s.gradient[i].error) : kLargestGradient;
  }
  for (int i = 0; i < (s.is == Slope::Is::anything ? 2 : 1); ++i) append(to.low, low), append(to.high, high);
  to.first.push_back(static_cast<uint32_t>(to.low.size() / sizeof(Gradient)));
}

}  // namespace

std::optional<glm::dvec2> exact_gradient(const Case& c, uint64_t pixel) {
  const Slope s = slope_at(inputs_of(c), pixel);
  if (s.is != Slope::Is::known) return {};
  return glm::dvec2(s.gradient[0].value, s.gradient[1].value);
}

Unpack unpack_gradient() {
  return {layout_of<Gradient>(), [](std::span<const std::byte> texels) {
            Bytes fields;
            for (size_t i = 0; i + 4 <= texels.size(); i += 4) {
              std::array<uint16_t, 2> halves;
              std::memcpy(&halves, &texels[i], sizeof halves);
              append(fields, Gradient{vec2(half_value(halves[0]), half_value(halves[1]))});
            }
            return fields;
          }};
}

Answer gradients_of(const Case& c) {
  const Inputs in = inputs_of(c);
  Expected e = {.first = {0}, .judged = judged_pixels(c, kSampledAbove)};
  const uint64_t count = e.judged.empty() ? pixels(c) : e.judged.size();
  for (uint64_t i = 0; i < count; ++i) add(e, slope_at(in, e.judged.empty() ? i : e.judged[i]));
  return {{"gradients", std::move(e)}};
}

}  // namespace assay::depth_gradients
