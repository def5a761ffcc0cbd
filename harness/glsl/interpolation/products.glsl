// Differences of products that lose nothing to cancellation. The includer's params have probe_factor and probe_addend
// (formats/interpolation.h).
#ifndef HARNESS_GLSL_INTERPOLATION_PRODUCTS
#define HARNESS_GLSL_INTERPOLATION_PRODUCTS
layout(constant_id = 1) const uint SPLIT_PRODUCTS = 0u;  // 1: never by fma, for comparison

// Whether this device's fma rounds once; Vulkan does not promise it. The same for every invocation.
bool multiply_add_is_fused() {
  precise const float probe = fma(params.probe_factor, params.probe_factor, params.probe_addend);
  return SPLIT_PRODUCTS == 0u && probe == 5.9604644775390625e-8;
}

// What rounding took from p = a * b: exactly a * b - p. Dekker 1971, the halves by Veltkamp.
float product_error(float a, float b, float p) {
  precise const float ca = 4097.0 * a, cb = 4097.0 * b;
  precise const float ah = ca - (ca - a), bh = cb - (cb - b);
  precise const float al = a - ah, bl = b - bh;
  precise const float error = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
  return error;
}

// a * b - c * d to 2 units of roundoff of the result. Fused: Kahan's (Jeannerod, Louvet, Muller 2013).
float difference_of_products(bool fused, float a, float b, float c, float d) {
  precise const float q = c * d;
  if (fused) {
#ifdef MUTANT_9106  // what the product lost is not given back
    precise const float error = 0.0;
#else
    precise const float error = fma(-c, d, q);
#endif
    precise const float difference = fma(a, b, -q);
    precise const float sum = difference + error;
    return sum;
  }
  precise const float p = a * b;
#ifdef MUTANT_9106
  precise const float error = 0.0;
#else
  precise const float error = product_error(a, b, p) - product_error(c, d, q);
#endif
  precise const float sum = (p - q) + error;
  return sum;
}
#endif
