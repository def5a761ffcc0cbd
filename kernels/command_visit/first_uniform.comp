#version 460
#define SLOT 0u
#define EARLY_OUT kUniformLists
#include "kernels/command_visit/visit.glsl"
