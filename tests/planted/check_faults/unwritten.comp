#version 460
#define UNWRITTEN
#include "tests/planted/check_faults/body.glsl"
