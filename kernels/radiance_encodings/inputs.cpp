#include "kernels/radiance_encodings/inputs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/radiance_encodings/oracle.h"

namespace assay::radiance_encodings {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

Case case_of(const std::vector<vec3>& colours, Extent e) {
  Case c = {.extent = e};
  c.set_params(EncodingParams{static_cast<uint32_t>(colours.size())});
  c.set_input("colours", colours);
  return c;
}
Case case_of(const std::vector<vec3>& colours) { return case_of(colours, {static_cast<uint32_t>(colours.size()), 1}); }

// Largest channels spread evenly by their logarithm, the others less by a ratio up to `most`.
std::vector<vec3> spread(Pcg32& rng, size_t count, double least, double greatest, double most) {
  std::vector<vec3> colours;
  for (size_t i = 0; i < count; ++i) {
    const double peak = least * std::pow(greatest / least, rng.unit());
    vec3 c = vec3(static_cast<float>(peak));
    for (int k = 0; k < 3; ++k) c[k] = static_cast<float>(peak * std::pow(most, -rng.unit()));
    c[static_cast<int>(rng.below(3))] = static_cast<float>(peak);
    colours.push_back(c);
  }
  return colours;
}

// The same number in each channel, and in each alone.
std::vector<vec3> of_numbers(const std::vector<float>& numbers) {
  std::vector<vec3> colours;
  for (const float v : numbers)
    for (const vec3& c : {vec3(v, v, v), vec3(v, 0, 0), vec3(0, v, 0), vec3(0, 0, v), vec3(v, 1, 1e-3f)})
      colours.push_back(c);
  return colours;
}

// And the floats beside them.
std::vector<float> with_neighbours(const std::vector<float>& numbers) {
  std::vector<float> all;
  for (const float v : numbers)
    for (const float n : {std::nextafter(v, 0.0f), v, std::nextafter(v, kInf)}) all.push_back(n);
  return all;
}

std::vector<HardCase> hard_cases() {
  return {
      {"carries", "numbers that round up to the next power of two, of every exponent and mantissa's length",
       [] {
         std::vector<float> numbers;
         for (int e = -26; e <= 16; ++e)
           for (const double below : {0x1p-6, 0x1p-7, 0x1p-10, 0x1p-11})
             numbers.push_back(static_cast<float>(std::ldexp(2 - below, e)));
         return case_of(of_numbers(with_neighbours(numbers)));
       }},
      {"ties", "half-way between two codes, above even and odd ones",
       [] {
         std::vector<float> numbers;
         for (const double step : {0x1p-5, 0x1p-6, 0x1p-8, 0x1p-10})
           for (int k = 0; k < 8; ++k) numbers.push_back(static_cast<float>(1 + (k + 0.5) * step));
         return case_of(of_numbers(with_neighbours(numbers)));
       }},
      {"shared_511_5", "511.5 of the steps of the shared exponent rounds to 512, which has no code",
       [] {
         std::vector<float> numbers;
         for (int e = 0; e < 32; ++e)
           for (const double m : {255.5, 510.5, 511.0, 511.5, 512.0})
             numbers.push_back(static_cast<float>(std::ldexp(m, e - 24)));
         return case_of(of_numbers(with_neighbours(numbers)));
       }},
      {"largest", "the largest of each encoding and beyond, to infinity",
       [] {
         return case_of(of_numbers(with_neighbours({64512, 65024, 65280, 65407, 65408, 65409, 65472, 65504, 65519,
                                                    65520, 65535, 65536, 1e6f, 1e30f, 3e38f})));
       }},
      {"not_numbers", "NaN, infinities, negative numbers, both zeros",
       [] {
         return case_of(of_numbers({kNan, -kNan, kInf, -kInf, -1, -0.0f, 0, -1e-40f, -65504}));
       }},
      {"denormal", "denormal codes, and what is less than half of the least; denormal floats",
       [] {
         std::vector<float> numbers = {1e-4f, 0x1p-20f, 1e-40f, 0x1p-149f, 0x1p-126f};
         for (int e = -30; e < -13; ++e)
           for (const double m : {1.0, 1.25, 1.5, 1.75, 1.99}) numbers.push_back(static_cast<float>(std::ldexp(m, e)));
         return case_of(of_numbers(with_neighbours(numbers)));
       }},
      {"saturated", "6e4, 0.6 and 0.006 side by side, in every order",
       [] {
         return case_of({vec3(6e4f, 6e-1f, 6e-3f), vec3(6e-1f, 6e-3f, 6e4f), vec3(6e-3f, 6e4f, 6e-1f)});
       }},
      {"one_colour", "one thread of a group", [] { return case_of({vec3(0.3f, 0.2f, 0.1f)}); }},
      {"none", "no colour: no group",
       [] {
         return case_of({}, {1, 1});
       }},
      {"groups_and_one", "a thread of a group more",
       [] {
         Pcg32 rng(5);
         return case_of(spread(rng, 513, 1e-3, 1e3, 10));
       }},
  };
}

Case random_case(Random& r) {
  const Extent e = random_extent(r, 32);
  const size_t count = pixel_count(e);
  std::vector<vec3> colours;
  switch (r.branch({{"bits", 0.3}, {"even", 0.5}, {"near_codes", 0.2}})) {
    case 0:
      for (size_t i = 0; i < count; ++i) {
        const uint32_t words[3] = {r.rng.next(), r.rng.next(), r.rng.next()};
        vec3 c;
        std::memcpy(&c, words, sizeof c);
        colours.push_back(c);
      }
      break;
    case 1:
      colours = spread(r.rng, count, 1e-8, 1e5, 1e3);
      break;
    default:
      for (size_t i = 0; i < count; ++i) {
        vec3 c;
        for (int k = 0; k < 3; ++k)
          c[k] = static_cast<float>(std::ldexp(512 + r.rng.below(1024) / 2.0, static_cast<int>(r.rng.below(30)) - 24));
        colours.push_back(c);
      }
  }
  return case_of(colours, e);
}

std::vector<Case> smaller(const Case& c) {
  std::vector<Case> cases;
  const auto colours = c.input<vec3>("colours");
  for (const size_t parts : {2u, 16u})
    for (size_t k = 0; k < parts && colours.size() >= parts; ++k) {
      const auto some = colours.subspan(colours.size() * k / parts, colours.size() / parts);
      cases.push_back(case_of({some.begin(), some.end()}));
    }
  return cases;
}

// What is lost, over the classes of numerics that the encodings' goals are set for.
struct Loss {
  double of_channel = 0, of_blue = 0, of_largest = 0, of_luminance = 0, bias = 0;
};
Loss loss_of(std::span<const vec3> colours, std::span<const vec3> decoded) {
  Loss loss;
  for (size_t i = 0; i < colours.size(); ++i) {
    const glm::dvec3 c(colours[i]), off = glm::dvec3(decoded[i]) - c, share = glm::abs(off) / c;
    const glm::dvec3 luminance = {0.2126, 0.7152, 0.0722};
    const double signed_loss = glm::dot(off, luminance) / glm::dot(c, luminance);
    loss.of_channel = std::max({loss.of_channel, share.x, share.y});
    loss.of_blue = std::max(loss.of_blue, share.z);
    loss.of_largest = std::max(
        loss.of_largest, std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)}) / std::max({c.x, c.y, c.z}));
    loss.of_luminance = std::max(loss.of_luminance, std::fabs(signed_loss));
    loss.bias += signed_loss / static_cast<double>(colours.size());
  }
  return loss;
}

std::vector<Figure> figures(const Variant& v, const Case& c, const std::map<std::string, Bytes>& written) {
  const Bytes& bytes = written.at("decoded");
  const auto colours = c.input<vec3>("colours");
  const Loss loss = loss_of(colours, {reinterpret_cast<const vec3*>(bytes.data()), colours.size()});
  const bool is_r11 = v.name == "r11g11b10f", is_shared = v.name == "rgb9e5", is_half = v.name == "rgba16f";
  return {{"red, green, max", loss.of_channel,
           is_r11    ? 0x1p-7
           : is_half ? 4.9e-4
                     : 0},
          {"blue, max", loss.of_blue,
           is_r11    ? 0x1p-6
           : is_half ? 4.9e-4
                     : 0},
          // Half a step where the largest channel takes the next exponent: from 511.5 steps of the one before (README).
          {"of the largest channel, max", loss.of_largest, is_shared ? 1 / 511.5 : 0},
          {"luminance, max", loss.of_luminance, is_shared ? 8e-3 : 0},
          {"luminance, |mean|", std::fabs(loss.bias), is_r11 ? 2e-5 : 0}};
}

}  // namespace

Case typical(Extent e) {
  Pcg32 rng(0xe0c);
  return case_of(spread(rng, pixel_count(e), 1e-2, 1e2, 4), e);
}

ErrorTable errors() {
  const auto of = [](double most) {
    return [most] {
      Pcg32 rng(0xe0d);
      return case_of(spread(rng, size_t{1} << 20, 1e-2, 1e2, most));
    };
  };
  return {.classes = {{"grey", "all channels the same, 0.01 to 100", of(1)},
                      {"mild saturation", "channels within a ratio of 4, 0.01 to 100", of(4)}},
          .figures = figures};
}

Inputs inputs() {
  std::vector<std::string> branches = kExtentBranches;
  for (const char* b : {"bits", "even", "near_codes"}) branches.push_back(b);
  return {.random = random_case, .branches = branches, .hard = hard_cases(), .smaller = smaller};
}

}  // namespace assay::radiance_encodings
