// A pass of the program's own that does nothing.
#version 460
layout(local_size_x = 1) in;
void main() {}
