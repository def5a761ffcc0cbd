#version 460
#define SLOT 1u
#define EARLY_OUT kUniformLists
#include "kernels/command_visit/visit.glsl"
