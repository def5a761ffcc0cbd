#version 460
layout(location = 0) flat in uint instance;
layout(location = 0) out vec4 light;

void main() { light = vec4(1, 2, 4, 0.25); }
