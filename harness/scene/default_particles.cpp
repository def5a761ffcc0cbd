// The 2000 particles of `default`.
#include "harness/scene/default_scene.h"

namespace assay::scene::builtin {

void add_default_particles(Scene& s) {
  uint32_t seed = 100;
  // Over a bay's lamps on either side, and a column of it in the nave.
  for (uint32_t bay = 0; bay < kBays; ++bay)
    for (const double sign : {-1.0, 1.0})
      add_particles(s, {.position = {sign * 2.6, 0.6, middle(bay) + 2},
                        .count = 75,
                        .radius = 0.28f,
                        .opacity = 0.16f,
                        .colour = {0.75f, 0.72f, 0.7f},
                        .height = 3,
                        .seed = seed++});
  for (uint32_t bay = 0; bay < kBays; ++bay)
    add_particles(s, {.kind = EmitterKind::dust,
                      .position = {0, 2.5, middle(bay)},
                      .half_extents = {4, 2.3, kBayLength_m / 2},
                      .count = 100,
                      .radius = 0.02f,
                      .opacity = 0.5f,
                      .colour = {0.9f, 0.85f, 0.7f},
                      .seed = seed++});
}

}  // namespace assay::scene::builtin
