// The form that is in wide use: project the vertices, solve on the screen, divide by the interpolated 1/w, and take as
// derivatives the difference to the next pixel. Errors are of the screen (1e-4 px), so they grow as triangles shrink; it is
// infinite at w = 0; and beyond the horizon there is no next pixel.
Interpolated interpolate(Triangle t) {
  const vec3 inverse_w = 1.0 / vec3(t.corners[0].z, t.corners[1].z, t.corners[2].z);
  const vec2 p0 = t.corners[0].xy * inverse_w.x, p1 = t.corners[1].xy * inverse_w.y, p2 = t.corners[2].xy * inverse_w.z;
  const vec2 a = p1 - p0, b = p2 - p0;
  const float area = a.x * b.y - b.x * a.y;
  const vec3 scaled = inverse_w * (1.0 / area);
  const vec3 slope_x = vec3(p1.y - p2.y, p2.y - p0.y, p0.y - p1.y) * scaled;  // of lambda / w, along x of NDC
  const vec3 slope_y = vec3(p2.x - p1.x, p0.x - p2.x, p1.x - p0.x) * scaled;
  const vec2 from_p0 = t.offset / t.half_extent - p0;
  const vec3 over_w = vec3(inverse_w.x, 0, 0) + from_p0.x * slope_x + from_p0.y * slope_y;
  const float sum = over_w.x + over_w.y + over_w.z;
  Interpolated r;
  r.weights = over_w / sum;
  const vec3 step_x = over_w + slope_x / t.half_extent.x, step_y = over_w + slope_y / t.half_extent.y;
  const vec3 d_dx = step_x / (step_x.x + step_x.y + step_x.z) - r.weights;
  const vec3 d_dy = step_y / (step_y.x + step_y.y + step_y.z) - r.weights;
  r.derivatives = vec4(d_dx.yz, d_dy.yz);
  r.clockwise = area > 0.0;
  return r;
}
