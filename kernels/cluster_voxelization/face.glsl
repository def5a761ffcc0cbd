// A face of an item as a polygon of its own: o + d ± u ± v, or a triangle from o to o + d ± v.
struct Face {
  bool triangle;
  vec3 d;
  vec3 u;
  vec3 v;
};

// Faces of a box: at the ends of a, -a, b, -b, c, -c; of a pyramid: the sides at a, -a, b, -b, the base.
Face face_of(ClusterItem item, uint index) {
  if (item.shape == kShapePyramid) {
    if (index == 4u) return Face(false, item.c, item.a, item.b);
    const vec3 aside = index < 2u ? item.a : item.b, v = index < 2u ? item.b : item.a;
    return Face(true, item.c + ((index & 1u) == 0u ? aside : -aside), vec3(0.0), v);
  }
  const float side = (index & 1u) == 0u ? 1.0 : -1.0;
  const uint pair = index & ~1u;
  if (pair == 0u) return Face(false, side * item.a, item.b, item.c);
  if (pair == 2u) return Face(false, side * item.b, item.c, item.a);
  return Face(false, side * item.c, item.a, item.b);
}

vec3 normal_of(Face face) { return cross(face.triangle ? face.d : face.u, face.v); }

// Whether it may be seen from the eye, and whether it may look away; one that is seen from the side does both, and so
// does a face whose outer side rounding may mistake.
bvec2 front_and_back(ClusterItem item, Face face) {
  const vec3 normal = normal_of(face);
  const vec3 reach = face.triangle ? abs(item.c) + abs(face.d - item.c) : abs(face.u);
  const vec3 of_normal = sums(reach, abs(face.v)), outward = face.triangle ? -item.c : face.d;
  const float out_along = dot(normal, outward);
  if (abs(out_along) <= room_of(of_normal, abs(outward))) return bvec2(true);
  const float on = dot(normal, item.origin) + (face.triangle ? 0.0 : dot(normal, face.d));
  const float beyond = out_along < 0.0 ? -on : on, room = room_of(of_normal, reach_of(item));
#ifdef MUTANT_24  // what looks away looks at the eye
  return bvec2(beyond >= -room, beyond <= room);
#else
  return bvec2(beyond <= room, beyond >= -room);
#endif
}

vec2 interval(ClusterItem item, Face face, vec3 m) {
  const float tip = dot(m, item.origin), middle = tip + dot(m, face.d);
  const float reach = abs(dot(m, face.u)) + abs(dot(m, face.v));
  if (face.triangle) return vec2(min(tip, middle - reach), max(tip, middle + reach));
  return middle + vec2(-reach, reach);
}

bool is_beyond(ClusterItem item, Face face, vec3 m, bool larger) {
  const vec2 there = interval(item, face, m);
  const float slack = rounding(magnitudes(item, m));
  return larger ? there.x > slack : there.y < -slack;
}
bool is_in_column(ClusterItem item, Face face, uvec2 at) {
  return !is_beyond(item, face, vec3(1.0, 0.0, -column_edge(at.x)), false) &&
         !is_beyond(item, face, vec3(1.0, 0.0, -column_edge(at.x + 1u)), true) &&
         !is_beyond(item, face, vec3(0.0, 1.0, -row_edge(at.y)), false) &&
         !is_beyond(item, face, vec3(0.0, 1.0, -row_edge(at.y + 1u)), true);
}

// Its own plane, and those through the eye and its edges; the face's interval along each, and in depth, with room for
// rounding.
struct FacePlanes {
  vec3 normals[5];
  vec2 reach[5];
  vec2 depths;
};
FacePlanes planes_of(ClusterItem item, Face face) {
  FacePlanes planes;
  const vec3 o = item.origin;
  planes.normals[0] = normal_of(face);
  planes.normals[1] = face.triangle ? cross(o + face.d, face.v) : cross(o + face.d + face.v, face.u);
  planes.normals[2] = face.triangle ? cross(o, face.d + face.v) : cross(o + face.d - face.v, face.u);
  planes.normals[3] = face.triangle ? cross(o, face.d - face.v) : cross(o + face.d + face.u, face.v);
  planes.normals[4] = face.triangle ? planes.normals[1] : cross(o + face.d - face.u, face.v);
  for (uint i = 0u; i < 5u; ++i) {
    const float slack = rounding(magnitudes(item, planes.normals[i]));
    planes.reach[i] = interval(item, face, planes.normals[i]) + vec2(-slack, slack);
    if (i > 0u) planes.reach[i] = vec2(min(planes.reach[i].x, 0.0), max(planes.reach[i].y, 0.0));  // the eye is on them
  }
  const vec3 forward = vec3(0.0, 0.0, 1.0);
  const float slack = rounding(magnitudes(item, forward));
  planes.depths = interval(item, face, forward) + vec2(-slack, slack);
  planes.depths.x = max(planes.depths.x, 0.0);
  return planes;
}
