#version 460
#define NOT_A_NUMBER
#include "tests/planted/check_faults/body.glsl"
