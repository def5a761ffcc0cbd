#version 460
#define STRAY
#include "tests/planted/check_faults/body.glsl"
