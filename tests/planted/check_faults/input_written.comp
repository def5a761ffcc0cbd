#version 460
#define INPUT_WRITTEN
#include "tests/planted/check_faults/body.glsl"
