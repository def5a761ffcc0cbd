#version 460
#define SLOT 1u
#define EARLY_OUT kDivergentLists
#include "kernels/command_visit/visit.glsl"
