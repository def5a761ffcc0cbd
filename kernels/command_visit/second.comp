#version 460
#define SLOT 1u
#include "kernels/command_visit/visit.glsl"
