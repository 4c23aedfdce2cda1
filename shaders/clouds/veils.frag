// Veils over the picture: what they add or take, and what shows of the rest. Blended as colour + behind × a.
#include "shared/frame.h"

layout(binding = 0) uniform sampler2D veils;
layout(location = 0) out vec4 colour;

void main() { colour = textureLod(veils, gl_FragCoord.xy * frame.viewport.zw, 0.0); }
