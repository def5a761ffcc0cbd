// The vocabulary of kernel.cpp: everything a kernel says about itself, and nothing of how it is run. An author needs
// this header alone; oracles and inputs also include harness/oracle.h.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "harness/frame_inputs.h"
#include "harness/layout_table.h"
#include "harness/texture.h"

namespace assay {

// ---- Sizes ---------------------------------------------------------------------------------------------------------

struct Groups {  // workgroups of a dispatch
  uint32_t x = 1, y = 1, z = 1;
};

constexpr uint32_t ceil_div(uint32_t a, uint32_t b) { return a / b + (a % b != 0); }
constexpr uint64_t pixel_count(Extent e) { return uint64_t{e.width} * e.height; }
constexpr Extent tiles_of(Extent e, uint32_t side) { return {ceil_div(e.width, side), ceil_div(e.height, side)}; }
constexpr uint64_t tile_count(Extent e, uint32_t side) { return pixel_count(tiles_of(e, side)); }

// ---- A case: what one run of a kernel starts from ----

// What an oracle may ask of the device whose answer it judges.
struct DeviceTraits {
  uint32_t subgroup_width = 8;
  uint32_t sub_pixel_bits = 8;  // rasteriser's vertex grid, subPixelPrecisionBits
  uint32_t sub_texel_bits = 8;  // filter weights, subTexelPrecisionBits
  uint32_t mipmap_bits = 8;     // level of detail, mipmapPrecisionBits
};

struct Case {
  std::string name = {};
  uint64_t seed = 0;
  Extent extent = {};
  Bytes parameters = {};                     // the kernel's parameter struct
  std::map<std::string, Bytes> inputs = {};  // a read or updated port's elements, or an image's rows
  std::map<std::string, std::vector<Texture>> textures = {};
  DeviceTraits device = {};  // filled in by the harness before the oracle runs
  bool judge_all = false;    // nightly, set by the harness: no sampling of large extents

  template <class T>
  T params() const {
    if (parameters.size() != sizeof(T)) throw std::logic_error("parameters of another type asked for");
    T t;
    std::memcpy(&t, parameters.data(), sizeof(T));
    return t;
  }
  template <class T>
  void set_params(const T& t) {
    parameters.resize(sizeof(T));
    std::memcpy(parameters.data(), &t, sizeof(T));
  }
  template <class T>
  std::span<const T> input(const std::string& port) const {
    const auto it = inputs.find(port);
    if (it == inputs.end()) throw std::logic_error("the case has no input " + port);
    return {reinterpret_cast<const T*>(it->second.data()), it->second.size() / sizeof(T)};
  }
  template <class T>
  void set_input(const std::string& port, std::span<const T> values) {
    const auto b = std::as_bytes(values);
    inputs[port] = Bytes(b.begin(), b.end());
  }
  template <class T>
  void set_input(const std::string& port, const std::vector<T>& values) {
    set_input(port, std::span<const T>(values));
  }
};

using Count = std::function<uint64_t(const Case&)>;
inline uint64_t pixels(const Case& c) { return pixel_count(c.extent); }
inline Count fixed(uint64_t n) {
  return [n](const Case&) { return n; };
}

// ---- Ports: the typed resources of a kernel ----

enum class Use { reads, writes, updates };
enum class PortKind { buffer, image, textures };

// Bound in the shader by name. In the frame a written port is the resource `<kernel>.<port>`; a reader or updater lists
// the producers that it accepts, latest first, and the first present wins. `updates` makes a new version in the same
// memory. A port without producers is filled from the case.
struct Port {
  std::string name;
  Use use = Use::reads;
  PortKind kind = PortKind::buffer;
  Layout layout = {};                // of a buffer's element
  Count count = {};                  // elements of a buffer, textures in an array of them
  Format format = Format::r32_uint;  // of an image
  std::optional<Format> view = {};   // a second format of equal size that shaders see instead of `format`
  // Of an image that is read and comes in several formats: the case's. A frame's has the one that its maker gave it.
  std::function<Format(const Case&)> format_in = {};
  std::function<Extent(const Case&)> extent = {};  // of an image; the case's where empty
  std::vector<std::string> producers = {};
  // Variants that have the port; empty: all. To the others it does not exist: neither bound nor judged nor counted.
  std::vector<std::string> only_in = {};
};

inline Format format_of(const Port& p, const Case& c) { return p.format_in ? p.format_in(c) : p.format; }

template <class T>
Port reads(std::string name, Count n, std::vector<std::string> producers = {}) {
  return {.name = std::move(name),
          .use = Use::reads,
          .layout = layout_of<T>(),
          .count = std::move(n),
          .producers = std::move(producers)};
}
template <class T>
Port writes(std::string name, Count n) {
  return {.name = std::move(name), .use = Use::writes, .layout = layout_of<T>(), .count = std::move(n)};
}
template <class T>
Port updates(std::string name, Count n, std::vector<std::string> producers = {}) {
  return {.name = std::move(name),
          .use = Use::updates,
          .layout = layout_of<T>(),
          .count = std::move(n),
          .producers = std::move(producers)};
}
inline Port reads_image(std::string name, Format f, std::vector<std::string> producers = {}) {
  return {.name = std::move(name),
          .use = Use::reads,
          .kind = PortKind::image,
          .format = f,
          .producers = std::move(producers)};
}
inline Port writes_image(std::string name, Format f) {
  return {.name = std::move(name), .use = Use::writes, .kind = PortKind::image, .format = f};
}
inline Port updates_image(std::string name, Format f, std::vector<std::string> producers = {}) {
  return {.name = std::move(name),
          .use = Use::updates,
          .kind = PortKind::image,
          .format = f,
          .producers = std::move(producers)};
}
inline Port reads_textures(std::string name, uint64_t slots, std::vector<std::string> producers = {}) {
  return {.name = std::move(name),
          .use = Use::reads,
          .kind = PortKind::textures,
          .count = fixed(slots),
          .producers = std::move(producers)};
}

// ---- Passes ----

// A compute pass. `groups` for a direct one; `indirect` names a port of DispatchArgs, `first_args` its entry.
// With `repeat` the pass runs once a row of a table: the row number is the shader's `row`, and is added to first_args.
struct Dispatch {
  std::string shader;
  std::function<Groups(const Case&)> groups = {};
  std::string indirect = {};
  Count first_args = {};  // 0 where empty
  Count repeat = {};
};

// Counter-clockwise in framebuffer coordinates of glTF's right-handed world faces front.
enum class Cull { none, back, front };
enum class Compare { always, less, greater, greater_equal, equal };
enum class Blend { none, over, add };

// Vertices come from storage buffers by gl_VertexIndex; there is no vertex input.
struct DrawCall {
  std::string vertex, fragment;
  Cull cull = Cull::none;
  Count first = {}, count = {};  // entries of the command port; in a draw without `commands`, first vertex and vertices
  std::string count_port = {};   // a buffer of one uint that bounds `count` from the device's side
};
struct ColourTarget {
  std::string port;
  std::optional<glm::uvec4> clear = {};  // bits; loaded where empty
  Blend blend = Blend::none;
};
struct DepthTarget {
  std::string port;
  Compare compare = Compare::greater;  // reversed depth
  bool write = true;
  std::optional<float> clear = {};
};
// One rendering scope: targets, then calls in order.
struct Draw {
  std::vector<ColourTarget> colours = {};
  std::optional<DepthTarget> depth = {};
  std::string indices = {};   // a port of uint; empty: not indexed
  std::string commands = {};  // a port of DrawCommand; empty: direct
  std::vector<DrawCall> calls = {};
};

// Every 32-bit word of a buffer becomes `value`.
struct Clear {
  std::string port;
  uint32_t value = 0;
};

using Pass = std::variant<Dispatch, Draw, Clear>;

// ---- Bounds ----

enum class Judge { exact, ulps, within, same_set, between, bits };

// A packed element as fields of a word each, for bounds that speak of them singly. `apply` takes the payload of the
// bound's only port; comparison and the oracle's answer are of what it returns, as many elements as before.
struct Unpack {
  Layout layout;
  std::function<Bytes(std::span<const std::byte>)> apply;
};

// What is allowed of a port and why. `between` may join several ports of equal count (their elements side by side).
// `bits` are words of flags: those of `low` must be set, those beyond `high` must not.
struct Bound {
  std::vector<std::string> ports;
  Judge judge = Judge::exact;
  double limit = 0;
  std::string reason;
  std::optional<Unpack> unpack = {};
  std::string answer = {};  // its name in the oracle's answer; the first port's where empty
};
inline Bound exact(std::string port, std::string reason) {
  return {{std::move(port)}, Judge::exact, 0, std::move(reason)};
}
inline Bound ulps(std::string port, double n, std::string reason) {
  return {{std::move(port)}, Judge::ulps, n, std::move(reason)};
}
inline Bound within(std::string port, double absolute, std::string reason) {
  return {{std::move(port)}, Judge::within, absolute, std::move(reason)};
}
inline Bound same_set(std::string port, std::string reason) {
  return {{std::move(port)}, Judge::same_set, 0, std::move(reason)};
}
inline Bound between(std::vector<std::string> ports, std::string reason) {
  return {std::move(ports), Judge::between, 0, std::move(reason)};
}
inline Bound bits(std::string port, std::string reason) {
  return {{std::move(port)}, Judge::bits, 0, std::move(reason)};
}

// The oracle's answer for one bound.
struct Expected {
  // exact, ulps, within, same_set: the elements, one a live element in order. between: lowest and highest admissible
  // element, side by side ports joined, alternative after alternative.
  Bytes low = {}, high = {};  // `high` only for between and bits
  // between: alternatives of the i-th judged element are first[i] .. first[i+1]. More than one is undecided;
  // alternatives whose low and high differ in a float member count as one (a rounding interval), those that differ in
  // an integer member are undecided too.
  std::vector<uint32_t> first = {};
  std::vector<uint64_t> judged = {};  // which elements were judged, ascending; empty: all live ones
  struct Run {
    uint64_t first, count;
  };
  // Elements that must be written, in runs; every other element must be left untouched. Empty: all are live.
  // same_set compares each run as a multiset.
  std::optional<std::vector<Run>> live = {};
};
using Answer = std::map<std::string, Expected>;  // by the bound's first port, or the name that the bound gives

// ---- Variants, inputs, cost, kernel ----

enum class Feature {
  subgroup_ballot,
  subgroup_arithmetic,
  subgroup_shuffle,
  subgroup_clustered,
  primitive_id,
  clip_distance,
  draw_indirect_count,
  int64,
  image_int64_atomics,
  float16,
  descriptor_indexing,
  forward_progress,
  texture_compression_bc,
  sampler_anisotropy,  // that works: tried when the device is opened
};
const char* name_of(Feature);

struct Cost {
  uint64_t bytes_read = 0, bytes_written = 0, operations = 0;
};

struct Constant {  // a named specialisation constant and the values it is tried with, the default first
  std::string name;
  std::vector<uint32_t> values;
};

struct Variant {
  std::string name;
  std::vector<Pass> passes;
  std::vector<Constant> constants = {};
  std::vector<Feature> needs = {};
  uint32_t subgroup_min = 1, subgroup_max = 128;
  std::optional<std::vector<Bound>> bounds = {};  // in place of the kernel's
  bool baseline = false;                          // timed and its errors shown, but held only to memory safety
  bool anisotropic = false;                       // textures' sampler: up to 16 times as long as wide
  std::function<Cost(const Case&)> cost = {};     // in place of the kernel's
  std::string note = {};                          // one line: the idea
};

class Random;  // the generator's; every named branch is counted, and the check fails where one starves

struct HardCase {
  std::string name;  // after what it hits
  std::string why;   // why that is hard, one line
  std::function<Case()> make;
  bool nightly = false;
};

struct Inputs {
  std::function<Case(Random&)> random;
  std::vector<std::string> branches;  // every name that `random` may report
  std::vector<HardCase> hard;
  // Smaller cases that may still fail, largest step first; the shrinker tries them in turn.
  std::function<std::vector<Case>(const Case&)> smaller = {};
};

// How far a variant is off over classes of inputs, as figures beside the bounds; printed by the bench.
struct Figure {
  std::string quantity;  // "texels, p99.9"
  double value = 0;
  double limit = 0;  // a goal that value must not exceed; 0: none
};
struct ErrorTable {
  std::vector<HardCase> classes = {};  // a case each; nightly ones are for studies, which ask for them by name
  std::function<std::vector<Figure>(const Variant&, const Case&, const std::map<std::string, Bytes>& written)> figures =
      {};
};

// A one-line fault behind #ifdef MUTANT_n in `file`; run in every variant that compiles the file.
struct Mutant {
  std::string file;
  uint32_t n;
  std::string fault;
  std::string killed_by;  // a hard case's name
};

struct Kernel {
  std::string name;
  std::string source;  // where the technique comes from
  std::string default_variant;
  Layout params = {};
  std::vector<Port> ports;
  std::vector<Variant> variants;
  std::function<Answer(const Case&)> oracle;
  Inputs inputs;
  std::vector<Bound> bounds;
  std::vector<Mutant> mutants;
  std::function<Cost(const Case&)> cost;
  std::function<Case(Extent)> typical;                 // the benchmark's input at an extent
  std::vector<Extent> extents;                         // benchmarked, the first is CI's
  std::function<Case(const FrameInputs&)> frame = {};  // parameters, inputs without producers; empty: not in it
  double undecided_limit = 1e-4;  // share of `between`'s elements, of typical and random cases, that may be undecided
  std::string undecided_reason = {};  // why it is another than the rule's 1e-4
  ErrorTable errors = {};
};

const std::vector<Kernel>& all_kernels();             // a folder each, by name; defined in the generated registry
const Kernel& kernel_named(const std::string& name);  // throws, naming the nearest

inline bool has_port(const Variant& v, const Port& p) {
  if (p.only_in.empty()) return true;
  for (const std::string& name : p.only_in)
    if (name == v.name) return true;
  return false;
}
const Port& port_of(const Kernel&, const std::string& name);
const std::vector<Bound>& bounds_of(const Kernel&, const Variant&);
Cost cost_of(const Kernel&, const Variant&, const Case&);
}  // namespace assay
