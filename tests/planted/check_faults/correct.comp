#version 460
#include "tests/planted/check_faults/body.glsl"
