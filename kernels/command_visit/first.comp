#version 460
#define SLOT 0u
#include "kernels/command_visit/visit.glsl"
