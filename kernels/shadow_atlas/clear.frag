#version 460

// Nothing but depth is drawn, and that is the quad's.
void main() {}
