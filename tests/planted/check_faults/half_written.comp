#version 460
#define HALF_WRITTEN
#include "tests/planted/check_faults/body.glsl"
