#version 460
#define WRONG_VALUE
#include "tests/planted/check_faults/body.glsl"
