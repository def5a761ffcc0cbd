// What a SPIR-V module says of itself: bindings by name, their memory layouts, specialisation constants.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "harness/device/device.h"

namespace assay::device {

enum class BindingKind { storage_buffer, uniform_buffer, image, storage_image, textures, other };

struct Binding {
  std::string name;   // the port's: a block's only member, an image's variable
  std::string block;  // a block's own name
  BindingKind kind = BindingKind::other;
  uint32_t set = 0, slot = 0, count = 1;  // count: descriptors of an array
  bool reads = true, writes = false;
  bool active = true;            // false: declared, never used
  Layout element = {};           // of a storage block's array element, of a uniform block's member
  Scalar sampled = Scalar::f32;  // what an image's texels read as
  std::string format = {};       // of a storage image as GLSL writes it; empty: none
  uint32_t set_word = 0;         // the word of the module that holds the descriptor set's number
  std::string trouble = {};      // what no port can describe, such as an array of arrays
};

struct SpecialConstant {
  std::string name;
  uint32_t id = 0;
};

struct Reflection {
  std::vector<Binding> bindings;
  std::vector<SpecialConstant> constants;
  uint32_t push_bytes = 0;
};

// Made once a module and kept. Throws std::logic_error where the module cannot be parsed.
const Reflection& reflect(const Shader&);

}  // namespace assay::device
