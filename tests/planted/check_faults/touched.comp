#version 460
#define TOUCHED
#include "tests/planted/check_faults/body.glsl"
