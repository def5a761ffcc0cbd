#include "kernels/decal_atlas_sampling/material.h"

namespace assay::decal_atlas_sampling {

namespace {

using glm::dvec3;

// ---- Where

bool is_finite(const vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}
Interval dot(const vec4& row, const Intervals3& v) {
  return sum_of({exactly(row.x) * v[0], exactly(row.y) * v[1], exactly(row.z) * v[2]});
}
Interval dot_and_offset(const vec4& row, const Intervals3& p) {
  return sum_of({exactly(row.x) * p[0], exactly(row.y) * p[1], exactly(row.z) * p[2], exactly(row.w)});
}
Intervals3 turned(const ReceiverRecord& r, const Intervals3& v) {
  return {dot(r.row_x, v), dot(r.row_y, v), dot(r.row_z, v)};
}

Interval component(double v, double row) { return exactly(v) * exactly(row); }
Intervals3 turned_back(const ReceiverRecord& r, const vec3& v) {
  Intervals3 out;
  for (int i = 0; i < 3; ++i)
    out[static_cast<size_t>(i)] =
        sum_of({component(r.row_x[i], v.x), component(r.row_y[i], v.y), component(r.row_z[i], v.z)});
  return out;
}

enum class Inside { no, maybe, yes };
Inside inside(Interval q) {
  if (q.high < 0 || q.low > 1) return Inside::no;
  return q.low >= 0 && q.high <= 1 ? Inside::yes : Inside::maybe;
}

// ---- The sample

Interval usable(Interval i, bool finite) {
  const double limit = kLargestGradient;
  const Interval size = absolute(i);
  if (!finite || size.low >= limit) return exactly(limit);
  if (size.high < limit) return i;
  return hull(clamped(i, -limit, limit), exactly(limit));
}

struct Derivatives {  // of UV, a pixel
  Interval u_dx, v_dx, u_dy, v_dy;
};

TexelDerivatives in_texels(const Derivatives& d, const Atlas& a) {
  const Interval w = exactly(a.width), h = exactly(a.height);
  return {d.u_dx * w, d.v_dx * h, d.u_dy * w, d.v_dy * h};
}
Interval larger(Interval a, Interval b) { return {std::max(a.low, b.low), std::max(a.high, b.high)}; }
Interval smaller(Interval a, Interval b) { return {std::min(a.low, b.low), std::min(a.high, b.high)}; }

// A coordinate held away from its border's sides by half of what a sample takes in there.
Interval held(Interval at, double scale, double bias, Interval rho, uint32_t size, const Atlas& a) {
  const double last = std::ldexp(0.5, static_cast<int>(a.levels) - 1);
  const Interval taken_in = exactly(kInset) * smaller(at_least(rho, 0.5), exactly(last));
  const Interval inset = at_least(taken_in - exactly(a.border), 0) / exactly(size);
  const Interval room = at_least(exactly(0.5 * std::fabs(scale)) - inset, 0);
  const Interval centre = exactly(bias) + exactly(0.5 * scale);
  return smaller(larger(at, centre - room), centre + room);
}

struct DecalSample {
  Intervals4 albedo;
  Interval x, y, roughness;  // of the normal's map, 0..1
};

DecalSample sample_at(const DecalRecord& d, Interval u, Interval v, Interval rho, Interval level, const Atlas& a) {
  const Interval x = held(u, d.scale_bias.x, d.scale_bias.z, rho, a.width, a);
  const Interval y = held(v, d.scale_bias.y, d.scale_bias.w, rho, a.height, a);
  const Intervals4 normal = a.normal.sampled(d.page, x, y, level);
  return {a.albedo.sampled(d.page, x, y, level), normal[0], normal[1], a.roughness.sampled(d.page, x, y, level)[0]};
}

DecalSample trilinear(const DecalRecord& d, Interval u, Interval v, const Derivatives& along, const Atlas& a) {
  const TexelDerivatives t = in_texels(along, a);
  const Interval widest =
      exactly(kWidestRho) * larger(absolute(t.u_dx) + absolute(t.v_dx), absolute(t.u_dy) + absolute(t.v_dy));
  return sample_at(d, u, v, widest, a.albedo.level_of(t), a);
}

void add(DecalSample& to, const DecalSample& s, Interval weight) {
  for (size_t c = 0; c < 4; ++c) to.albedo[c] = to.albedo[c] + s.albedo[c] * weight;
  to.x = to.x + s.x * weight, to.y = to.y + s.y * weight, to.roughness = to.roughness + s.roughness * weight;
}
DecalSample hull_of(const DecalSample& a, const DecalSample& b) {
  DecalSample s = a;
  for (size_t c = 0; c < 4; ++c) s.albedo[c] = hull(a.albedo[c], b.albedo[c]);
  s.x = hull(a.x, b.x), s.y = hull(a.y, b.y), s.roughness = hull(a.roughness, b.roughness);
  return s;
}

// Side by side along one derivative, as wide as the other, or as a tap's share of this one.
DecalSample along_axis(const DecalRecord& d, Interval u, Interval v, const Derivatives& f, bool is_x, const Atlas& a) {
  const TexelDerivatives t = in_texels(f, a);
  const Interval x2 = sum_of({square(t.u_dx), square(t.v_dx)}), y2 = sum_of({square(t.u_dy), square(t.v_dy)});
  const Interval taps = exactly(kAnisotropicTaps);
  const Interval width = square_root(larger(smaller(x2, y2), larger(x2, y2) / square(taps)));
  const Interval held_width = at_least(width, 1e-6);
  // log2: 3 ulp or 2^-21 (Vulkan's table).
  const Interval log = {std::log2(held_width.low), std::log2(held_width.high)};
  const double error = 0x1p-21 + 6 * bounded::u * std::max(std::fabs(log.low), std::fabs(log.high));
  const Interval level = a.albedo.level_of(Interval{log.low - error, log.high + error});
  DecalSample sum = {};
  for (uint32_t i = 0; i < kAnisotropicTaps; ++i) {
    const Interval at = exactly((i + 0.5) / kAnisotropicTaps - 0.5);
    add(sum,
        sample_at(d, u + (is_x ? f.u_dx : f.u_dy) * at, v + (is_x ? f.v_dx : f.v_dy) * at, exactly(kWidestRho) * width,
                  level, a),
        exactly(1.0 / kAnisotropicTaps));
  }
  return sum;
}
DecalSample tapped(const DecalRecord& d, Interval u, Interval v, const Derivatives& f, const Atlas& a) {
  const TexelDerivatives t = in_texels(f, a);
  const Interval x2 = sum_of({square(t.u_dx), square(t.v_dx)}), y2 = sum_of({square(t.u_dy), square(t.v_dy)});
  if (x2.low >= y2.high) return along_axis(d, u, v, f, true, a);
  if (x2.high < y2.low) return along_axis(d, u, v, f, false, a);
  return hull_of(along_axis(d, u, v, f, true, a), along_axis(d, u, v, f, false, a));
}

// ---- Blending

// Weights are products of one another; the distance fades the last quarter.
Interval fade_of(const DecalRecord& d, Interval distance) {
  if (!(d.fade_distance > 0)) return exactly(1);
  return clamped(exactly(4) * (exactly(1) - distance / exactly(d.fade_distance)), 0, 1);
}
double saturated(double v) { return v > 0 ? std::min(v, 1.0) : 0; }

Ball ball_of(const Intervals3& v) {
  dvec3 middle, radius;
  for (int i = 0; i < 3; ++i) {
    const Interval& axis = v[static_cast<size_t>(i)];
    middle[i] = (axis.low + axis.high) / 2, radius[i] = (axis.high - axis.low) / 2;
  }
  return {middle, glm::length(radius)};
}
Ball hull_of(const Ball& a, const Ball& b) {
  return {(a.value + b.value) / 2.0, glm::length(a.value - b.value) / 2 + std::max(a.error, b.error)};
}

// In the decal's frame: the decal's own normal instead, slopes added, or the decal's turned as the surface's is.
Intervals3 blended_normal(const Intervals3& base, const Intervals3& detail, uint32_t mode, Interval share) {
  if (mode == kNormalLinear)
    return {mixed(base[0], detail[0], share), mixed(base[1], detail[1], share), mixed(base[2], detail[2], share)};
  const Interval x = mixed(exactly(0), detail[0], share), y = mixed(exactly(0), detail[1], share),
                 z = mixed(exactly(1), detail[2], share);
  if (mode != kNormalReoriented) return {base[0] + x, base[1] + y, base[2] * z};
  const Intervals3 t = {base[0], base[1], base[2] + exactly(1)}, u = {-x, -y, z};
  const Interval along = sum_of({t[0] * u[0], t[1] * u[1], t[2] * u[2]});
  return {t[0] * along - u[0] * t[2], t[1] * along - u[1] * t[2], t[2] * along - u[2] * t[2]};
}

void blend_normal(BlendedMaterial& m, const DecalRecord& d, const Intervals3 (&frame)[3], const DecalSample& s,
                  Interval share) {
  const Interval x = exactly(2) * s.x - exactly(1), y = exactly(2) * s.y - exactly(1);
  const Interval z = square_root(at_least(exactly(1) - sum_of({square(x), square(y)}), 0));
  Intervals3 base, world;
  for (size_t i = 0; i < 3; ++i) base[i] = assay::dot(m.normal, ball_of(frame[i]));
  const Intervals3 n = blended_normal(base, {x, y, z}, d.normal_mode, share);
  for (size_t i = 0; i < 3; ++i) world[i] = sum_of({n[0] * frame[0][i], n[1] * frame[1][i], n[2] * frame[2][i]});
  const Interval squared = sum_of({square(world[0]), square(world[1]), square(world[2])});
  m.normal_touched = true;
  if (squared.high < kLeastNormal || squared.low >= kLargestNormal) return;
  const Ball direction = normalised(ball_of(world), 1e-3);
  const bool is_sure = squared.low >= kLeastNormal && squared.high < kLargestNormal;
  m.normal = is_sure ? direction : hull_of(m.normal, direction);
}

}  // namespace

void apply(BlendedMaterial& m, const DecalRecord& d, const ReceiverRecord* receiver, SurfacePoint p, const Atlas& a,
           Filtering filtering) {
  if (!is_finite(d.row_x) || !is_finite(d.row_y) || !is_finite(d.row_z)) return;  // the pixel is nowhere
  Intervals3 frame[3];
  for (int i = 0; i < 3; ++i) {
    const vec3 axis = i == 0 ? d.tangent : i == 1 ? d.bitangent : d.outward;
    frame[i] = {exactly(axis.x), exactly(axis.y), exactly(axis.z)};
    if (receiver != nullptr) frame[i] = turned_back(*receiver, axis);
  }
  if (receiver != nullptr) {
    const Intervals3 at = p.position;
    p.position = {dot_and_offset(receiver->row_x, at), dot_and_offset(receiver->row_y, at),
                  dot_and_offset(receiver->row_z, at)};
    p.d_dx = turned(*receiver, p.d_dx), p.d_dy = turned(*receiver, p.d_dy);
  }
  const Interval q[3] = {dot_and_offset(d.row_x, p.position), dot_and_offset(d.row_y, p.position),
                         dot_and_offset(d.row_z, p.position)};
  Inside where = Inside::yes;
  for (const Interval& axis : q) where = std::min(where, inside(axis));
  if (where == Inside::no) return;

  const Interval scale_u = exactly(d.scale_bias.x), scale_v = exactly(d.scale_bias.y);
  const Derivatives along = {
      usable(dot(d.row_x, p.d_dx) * scale_u, p.finite_dx), usable(dot(d.row_y, p.d_dx) * scale_v, p.finite_dx),
      usable(dot(d.row_x, p.d_dy) * scale_u, p.finite_dy), usable(dot(d.row_y, p.d_dy) * scale_v, p.finite_dy)};
  const Interval u = clamped(q[0], 0, 1) * scale_u + exactly(d.scale_bias.z),
                 v = clamped(q[1], 0, 1) * scale_v + exactly(d.scale_bias.w);
  const DecalSample s = filtering == Filtering::taps ? tapped(d, u, v, along, a) : trilinear(d, u, v, along, a);

  BlendedMaterial with = m;
  const Interval covered = clamped(s.albedo[3], 0, 1) * fade_of(d, p.distance);
  const Interval base_share = exactly(saturated(d.weights.x)) * covered;
  if (d.weights.x > 0)
    for (size_t i = 0; i < 3; ++i) with.base[i] = mixed(m.base[i], clamped(s.albedo[i], 0, 1), base_share);
  if (d.weights.y > 0) blend_normal(with, d, frame, s, exactly(saturated(d.weights.y)) * covered);
  if (d.weights.z > 0)
    with.roughness = mixed(m.roughness, clamped(s.roughness, 0, 1), exactly(saturated(d.weights.z)) * covered);

  if (where == Inside::yes) {
    m = with;
    return;
  }
  for (size_t i = 0; i < 3; ++i) m.base[i] = hull(m.base[i], with.base[i]);
  m.roughness = hull(m.roughness, with.roughness);
  if (with.normal_touched) m.normal = hull_of(m.normal, with.normal);
  m.normal_touched |= with.normal_touched, m.undecided = true;
}

}  // namespace assay::decal_atlas_sampling
