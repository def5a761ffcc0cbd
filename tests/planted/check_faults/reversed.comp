#version 460
#define REVERSED
#include "tests/planted/check_faults/body.glsl"
