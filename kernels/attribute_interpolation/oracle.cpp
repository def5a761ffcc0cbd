#include "kernels/attribute_interpolation/oracle.h"

#include <cfloat>

#include "harness/judged.h"
#include "kernels/attribute_interpolation/codes.h"
#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

std::string answer_name(const std::string& port, const std::string& formula, uint32_t encoding) {
  return port + "/" + formula + "/" + std::to_string(encoding);
}

namespace {

constexpr uint64_t kSampledAbove = 1u << 16;  // pixels

template <class Fields>
void append(Bytes& to, const Fields& f) {
  const auto* p = reinterpret_cast<const std::byte*>(&f);
  to.insert(to.end(), p, p + sizeof f);
}

// One judged element. What is undetermined counts as two alternatives, so that it is told from what was judged.
template <class Fields>
void add(Expected& to, const Fields& low, const Fields& high, bool determined) {
  for (int i = 0; i < (determined ? 1 : 2); ++i) append(to.low, low), append(to.high, high);
  to.first.push_back(static_cast<uint32_t>(to.low.size() / sizeof(Fields)));
}

float at_most(double v) {
  const auto f = static_cast<float>(v);
  return double{f} > v ? std::nextafter(f, -HUGE_VALF) : f;
}
float at_least(double v) {
  const auto f = static_cast<float>(v);
  return double{f} < v ? std::nextafter(f, HUGE_VALF) : f;
}

Interval around(const RoundedDouble& r) { return {r.value - r.error, r.value + r.error}; }
Interval weight_of(const Hit& h, int k) {
  if (!h.determined) return h.clamped ? Interval{0, 1 + 8 * u} : Interval{-FLT_MAX, FLT_MAX};
  const Interval i = around(h.weights[k]);
  if (!h.clamped) return i;
  return {std::max(i.low, 0.0), std::min(i.high, 1 + 8 * u)};
}
Few<Interval, 4> derivatives_of(const Hit& h) {
  Few<Interval, 4> d;
  for (int k = 0; k < 4; ++k) d[k] = h.determined ? around(h.derivatives[k]) : Interval{-FLT_MAX, FLT_MAX};
  return d;
}

struct Pixel {
  bool seen = false;
  bool flipped = false;
  Hit hit;
  TangentFrame frame;
};

void add_barycentrics(Expected& to, const Pixel& p, uint32_t encoding) {
  if (!p.seen) return add(to, barycentric_fields(0, encoding), barycentric_fields(0, encoding), true);
  const Interval a = stored_weight(weight_of(p.hit, 1), encoding), b = stored_weight(weight_of(p.hit, 2), encoding);
  add(to, BarycentricFields{{at_most(a.low), at_most(b.low)}, 0},
      BarycentricFields{{at_least(a.high), at_least(b.high)}, 1}, p.hit.determined);
}

struct Flag {
  uint low, high;
};
Flag flag(bool known, bool set) { return known ? Flag{set, set} : Flag{0, 1}; }
Flag is_negative(const Direction& d) {
  const RoundedDouble& z = d.xyz[2];
  return flag(d.determined && (is_zero(z) || std::fabs(z.value) > z.error), z.value < 0);
}

void add_derivatives(Expected& to, const Pixel& p, uint32_t encoding) {
  if (!p.seen) return add(to, derivative_fields(uvec2(0), encoding), derivative_fields(uvec2(0), encoding), true);
  const auto d = stored_derivatives(derivatives_of(p.hit), encoding);
  const Flag front = flag(p.hit.determined, p.hit.clockwise == p.flipped), normal = is_negative(p.frame.normal),
             tangent = is_negative(p.frame.tangent), left = flag(true, p.frame.left_handed);
  DerivativeFields low = {{}, front.low, normal.low, tangent.low, left.low, 0},
                   high = {{}, front.high, normal.high, tangent.high, left.high, 1};
  for (int k = 0; k < 4; ++k) low.derivatives[k] = at_most(d[k].low), high.derivatives[k] = at_least(d[k].high);
  add(to, low, high, p.hit.determined);
}

// The two numbers stored of a direction.
void bound_direction(const Direction& d, uint32_t encoding, vec2& low, vec2& high) {
  const Few<RoundedDouble, 2> stored =
      encoding == kAttributesHalves ? Few<RoundedDouble, 2>{d.xyz[0], d.xyz[1]} : lambert(d);
  for (int k = 0; k < 2; ++k) {
    const Interval i = stored_direction(d.determined ? around(stored[k]) : Interval{-1, 1}, encoding);
    low[k] = at_most(i.low), high[k] = at_least(i.high);
  }
}

void add_frame(Expected& to, const Pixel& p, uint32_t encoding) {
  if (!p.seen) return add(to, frame_fields(uvec2(0), encoding), frame_fields(uvec2(0), encoding), true);
  FrameFields low = {}, high = {};
  high.blank = 1;
  bound_direction(p.frame.normal, encoding, low.normal, high.normal);
  bound_direction(p.frame.tangent, encoding, low.tangent, high.tangent);
  add(to, low, high, p.frame.normal.determined && p.frame.tangent.determined);
}

void add_unpacked(Expected& to, const Pixel& p) {
  UnpackedAttributes low = {}, high = {};
  if (!p.seen) return add(to, low, high, true);
  const auto d = derivatives_of(p.hit);
  for (int k = 0; k < 4; ++k) low.derivatives[k] = at_most(d[k].low), high.derivatives[k] = at_least(d[k].high);
  for (int k = 0; k < 3; ++k) {
    const Interval weight = weight_of(p.hit, k);
    low.barycentrics[k] = at_most(weight.low), high.barycentrics[k] = at_least(weight.high);
    const auto component = [k](const Direction& v) {
      return v.determined ? around(v.xyz[k]) : Interval{-1.001, 1.001};
    };
    const Interval n = component(p.frame.normal), t = component(p.frame.tangent);
    low.normal[k] = at_most(n.low), high.normal[k] = at_least(n.high);
    low.tangent[k] = at_most(t.low), high.tangent[k] = at_least(t.high);
  }
  add(to, low, high, p.hit.determined && p.frame.normal.determined && p.frame.tangent.determined);
}

// What a consumer makes of an interval of stored numbers.
Interval decoded_weight(const Pixel& p, int k, uint32_t encoding) {
  Interval i = stored_weight(weight_of(p.hit, k), encoding);
  if (encoding != kAttributesHalves) i.low *= 1 - 6 * u, i.high *= 1 + 6 * u;  // a division, 2.5 ulp
  return i;
}

// A direction turned by what half a step of each number may turn it. README.md, "Bounds".
double decoding_error(const Direction& d, uint32_t encoding) {
  if (encoding != kAttributesHalves) {
    const Few<RoundedDouble, 2> e = lambert(d);
    const double moved = std::hypot(e[0].error + 0.5 / 32767 + 2 * u, e[1].error + 0.5 / 32767 + 2 * u);
    return 2 * moved + 16 * u;
  }
  const double moved = std::hypot(d.xyz[0].error + 0x1p-12, d.xyz[1].error + 0x1p-12);
  return 2 * (moved + std::sqrt(2 * moved + moved * moved)) + 16 * u;
}

void bound_decoded(const Direction& d, uint32_t encoding, vec3& low, vec3& high) {
  const double error = d.determined ? decoding_error(d, encoding) : 0;
  for (int k = 0; k < 3; ++k) {
    const double v = d.xyz[k].value;
    low[k] = d.determined ? at_most(v - error) : -1.001f;
    high[k] = d.determined ? at_least(v + error) : 1.001f;
  }
}

void add_decoded(Expected& to, const Pixel& p, uint32_t encoding) {
  DecodedAttributes low = {}, high = {};
  if (!p.seen) {
    low = {{1, 0, 0}, {}, {}, {0, 0, 1}, {0, 0, 1}, 1, 0};
    return add(to, low, low, true);
  }
  const Interval a = decoded_weight(p, 1, encoding), b = decoded_weight(p, 2, encoding);
  low.barycentrics = {at_most(1 - a.high - b.high - 4 * u), at_most(a.low), at_most(b.low)};
  high.barycentrics = {at_least(1 - a.low - b.low + 4 * u), at_least(a.high), at_least(b.high)};
  const auto d = stored_derivatives(derivatives_of(p.hit), encoding);
  const auto derivative = [](const Interval& of_1, const Interval& of_2, vec3& to_low, vec3& to_high) {
    const double rounding = u * std::max(std::fabs(of_1.low + of_2.low), std::fabs(of_1.high + of_2.high));
    to_low = {at_most(-of_1.high - of_2.high - rounding), at_most(of_1.low), at_most(of_2.low)};
    to_high = {at_least(-of_1.low - of_2.low + rounding), at_least(of_1.high), at_least(of_2.high)};
  };
  derivative(d[0], d[1], low.d_dx, high.d_dx);
  derivative(d[2], d[3], low.d_dy, high.d_dy);
  bound_decoded(p.frame.normal, encoding, low.normal, high.normal);
  bound_decoded(p.frame.tangent, encoding, low.tangent, high.tangent);
  low.handedness = high.handedness = p.frame.left_handed ? -1.0f : 1.0f;
  const Flag front = flag(p.hit.determined, p.hit.clockwise == p.flipped);
  low.front_facing = front.low, high.front_facing = front.high;
  add(to, low, high, p.hit.determined && p.frame.normal.determined && p.frame.tangent.determined);
}

}  // namespace

Answer interpolate(const Case& c) {
  const Scene scene = scene_of(c);
  const std::vector<uint64_t> judged = judged_pixels(c, kSampledAbove, JudgedBorders::last);
  Answer answer;
  const auto expected = [&](const std::string& port, Formula f, uint32_t encoding) -> Expected& {
    Expected& e = answer[answer_name(port, name_of(f), encoding)];
    if (e.first.empty()) e.first = {0}, e.judged = judged;
    return e;
  };
  for_each_judged(c, judged, [&](uint64_t i) {
    const auto triangle = triangle_at(scene, i);
    for (const Formula f : kFormulas) {
      Pixel p;
      if (triangle) p = {true, triangle->flipped, hit(*triangle, f), {}};
      if (triangle) p.frame = frame_of(*triangle, p.hit);
      for (uint32_t encoding = 0; encoding < kAttributeLayouts; ++encoding) {
        add_barycentrics(expected("barycentrics", f, encoding), p, encoding);
        add_derivatives(expected("derivatives", f, encoding), p, encoding);
        add_frame(expected("tangent_frame", f, encoding), p, encoding);
        if (f == Formula::compensated) add_decoded(expected("decoded", f, encoding), p, encoding);
      }
      add_unpacked(expected("unpacked", f, 0), p);
    }
  });
  return answer;
}

}  // namespace assay::attribute_interpolation
