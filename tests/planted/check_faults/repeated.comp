#version 460
#define REPEATED
#include "tests/planted/check_faults/body.glsl"
