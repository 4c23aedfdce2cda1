// Reflection from rough surfaces. Compiled as GLSL and as double-precision C++.
// alpha is the GGX width: the square of glTF's roughness.

const float kGgxPi = 3.14159265358979323846;

// Density of microfacet normals; its integral with cos(theta) over the hemisphere is 1.
// Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 33.
float ggx_density(float n_dot_h, float alpha) {
  float a2 = alpha * alpha;
  float d = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
  return a2 / (kGgxPi * d * d);
}

// G / (4 n.l n.v), masking and shadowing correlated in height.
// Heitz, "Understanding the Masking-Shadowing Function", JCGT 2014, eq. 99.
float ggx_visibility(float n_dot_l, float n_dot_v, float alpha) {
  float a2 = alpha * alpha;
  float l = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0 - a2) + a2);
  float v = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0 - a2) + a2);
  return 0.5 / max(l + v, 1.0e-6);
}

// Schlick 1994: f0 is the reflectance at normal incidence.
vec3 schlick_fresnel(vec3 f0, float v_dot_h) {
  float m = 1.0 - v_dot_h;
  float m5 = m * m * m * m * m;
  return f0 + (vec3(1.0, 1.0, 1.0) - f0) * m5;
}
