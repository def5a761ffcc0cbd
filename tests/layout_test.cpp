// The comparison of SPIR-V with ports: it finds each planted mistake, and says kernel, shader, block, member, both
// values.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/lowered.h"
#include "tests/planted/device_layouts/layout.h"

namespace assay::tests {
namespace {

std::string errors_of(const std::string& variant) {
  const Kernel& k = planted("device_layouts");
  const auto errors = device::layout_errors(k, variant_of(k, variant));
  for (const std::string& e : errors) EXPECT_EQ(e.find('\n'), std::string::npos) << e;
  return fmt::format("{}", fmt::join(errors, "\n"));
}

TEST(Layout, TheRightShaderHasNoErrors) { EXPECT_EQ(errors_of("right"), ""); }

TEST(Layout, MistakesAreNamed) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"stride",
       "device_layouts: stride.comp: block 'items_block': an element has 124 bytes in the shader, 120 in Item"},
      {"stride", "member 'padding' at offset 120 is not in Item"},
      {"swapped", "member 'normal' is at offset 0 in the shader, 4 in Item"},
      {"swapped", "member 'key' is at offset 12 in the shader, 0 in Item"},
      {"renamed", "renamed.comp: block 'itemz_block': there is no port 'itemz'"},
      {"renamed", "port 'items' is in none of its passes"},
      {"params", "block 'params_block': member 'scale' is 1 x uint in the shader, 1 x float in LayoutParams"},
      {"read_only", "port 'results' is written, but every shader declares it readonly"},
      {"written", "port items is read, the shader may write it (readonly is missing)"},
      {"float_texels", "block 'picture': texels are float in the shader, uint in the port's rg32_uint"},
      {"image_format", "block 'stored': storage format is 'r16ui' in the shader, the port's r32_uint asks for 'r32ui'"},
      {"array_length", "member 'inners[0].kinds' is 2 x uint in the shader, 3 x uint in Item"},
      {"array_length", "member 'inners[1].place' is at offset 32 in the shader, 36 in Item"},
      {"missing_member", "member 'transform' at offset 56 of Item is not in the shader"},
      {"std430", "member 'normal' is at offset 16 in the shader, 4 in Item"},
      {"constant", "constant 'SPEEED' is in none of its shaders"},
      {"unused", "unused: port 'forgotten' is in none of its passes"},
  };
  for (const auto& [variant, message] : mistakes)
    EXPECT_NE(errors_of(variant).find(message), std::string::npos) << variant << " says:\n" << errors_of(variant);
}

TEST(Layout, AModuleAloneIsComparedToo) {
  const Kernel& k = planted("device_layouts");
  EXPECT_TRUE(device::layout_errors(device::shader(k.name, "right.comp"), k.ports, k.params).empty());
  EXPECT_EQ(
      device::layout_errors(device::shader(k.name, "read_only.comp"), k.ports, k.params),
      std::vector<std::string>{"device_layouts: read_only.comp: block 'results_block': port results is written, the "
                               "shader declares it readonly"});
}

TEST(Layout, AMismatchIsThrownBeforeAnythingRuns) {
  const Kernel& k = planted("device_layouts");
  Case c = {.name = "layouts"};
  c.extent = {2, 2};
  c.set_params(device_layouts::LayoutParams{});
  c.set_input("items", std::vector<device_layouts::Item>(4));
  c.set_input("words", std::vector<uint32_t>(64));
  c.set_input("picture", std::vector<uvec2>(4));
  EXPECT_NO_THROW(run_variant(*device(), k, "right", c));
  for (const Variant& v : k.variants) {
    if (v.name == "right") continue;
    EXPECT_THROW(run_variant(*device(), k, v.name, c), std::logic_error) << v.name;
  }
}

TEST(Layout, AMissingShaderIsNamed) {
  EXPECT_THROW(device::shader("device_layouts", "nothing.comp"), std::invalid_argument);
  EXPECT_EQ(device::shader("device_layouts", "right.comp", 12).mutant, 0u) << "no such mutant: as written";
}

TEST(Layout, CombinationsBeginWithTheDefault) {
  const Variant v = {.name = "v", .passes = {}, .constants = {{"B", {4, 8}}, {"A", {1, 2, 3}}}};
  const auto all = device::combinations(v);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(device::label_of(v, all[0]), "v[A=1,B=4]");
  EXPECT_EQ(device::label_of(v, {}), "v");
}

}  // namespace
}  // namespace assay::tests
