// All that the rest of Assay sees of a Vulkan device. Nothing here names a Vk type.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/device/shader.h"
#include "harness/kernel.h"

namespace assay::device {

// ---- Errors: one line each, what and where
// -----------------------------------------------------------------------------

struct Error : std::runtime_error {  // a failed call: expression, result name, file and line
  using std::runtime_error::runtime_error;
};
struct Lost : Error {  // VK_ERROR_DEVICE_LOST, or a fence not signalled in time (run); open a fresh device
  using Error::Error;
};
struct OutOfMemory : Error {
  using Error::Error;
};
struct NoSuchDevice : std::runtime_error {  // lists what there is
  using std::runtime_error::runtime_error;
};

// ---- Devices
// -----------------------------------------------------------------------------------------------------------

struct Info {
  uint32_t index = 0;
  std::string name, uuid, type, driver, driver_info,
      api;  // uuid: 32 hex digits; type: cpu, integrated, discrete, virtual
  uint32_t subgroup_min = 0, subgroup_max = 0;
  DeviceTraits traits = {};
  std::set<Feature> features = {};
  uint64_t max_buffer_range = 0, shared_memory = 0, memory_bytes = 0;
  uint32_t max_groups[3] = {};
  double timestamp_ns = 0;    // nanoseconds a tick; 0: no timestamps
  bool second_queue = false;  // a queue beside the first, for asynchronous compute
  std::string missing = {};   // why Assay cannot run on it at all; empty if it can
};

// How long a device must be busy before it is timed. A GPU that waited lowers its clocks: nvidia-smi, every 200 ms,
// showed an H100 at 345 MHz and busy before it showed 1980, and after 300 ms of work times were still up to 3.7 times
// too long.
inline double warm_up_ns(const Info& i) { return i.type == "cpu" ? 0 : 1e9; }

// Every physical device, in the loader's order. Throws Error where there is no Vulkan loader.
std::vector<Info> list();

enum class Validation { off, core, sync, gpuav };

struct Options {
  std::string select =
      {};  // index, UUID (a prefix of 8 digits or more), or part of a name; empty: the CPU device (lavapipe)
  Validation validation = Validation::off;
};

// The position in `infos` that Options::select names, by the rules above. Throws NoSuchDevice, which lists them.
size_t choose(std::span<const Info> infos, const std::string& select);

class Device;
struct Close {
  void operator()(Device*) const;
};
using Handle = std::unique_ptr<Device, Close>;
Handle open(const Options&);  // throws NoSuchDevice, Error
const Info& info(const Device&);
// Of the pipeline cache that an earlier run left on disk; 0: there was none that fits.
size_t loaded_cache_bytes(const Device&);
// Pipelines made since it was opened; they live as long as it does.
size_t pipeline_count(const Device&);
// Messages of the validation layer since the last call, one line each. Any is a failure of the test that caused it.
std::vector<std::string> validation_messages(Device&);
// Why the variant cannot run here ("needs forward_progress", "subgroup width 8 outside 16..64"); empty if it can.
std::string missing(const Info&, const Variant&);

// ---- Shaders
// -----------------------------------------------------------------------------------------------------------

std::span<const Shader> all_shaders();  // generated
// The file with MUTANT_n defined, or as written where it has no such mutant. Throws std::invalid_argument.
const Shader& shader(const std::string& kernel, const std::string& file, uint32_t mutant = 0);

// ---- Resources
// ---------------------------------------------------------------------------------------------------------

constexpr uint64_t kGuardBytes = 4096;  // behind the payload, inside the bound range

class Resource;  // a buffer, an image, or an array of textures
using Owned = std::shared_ptr<Resource>;
Owned make_buffer(Device&, const std::string& name, uint64_t payload_bytes);  // plus the guard
Owned make_image(Device&, const std::string& name, Format, std::optional<Format> view, Extent);
Owned make_textures(Device&, const std::string& name, std::span<const Texture>, uint64_t slots);
const std::string& name_of(const Resource&);
uint64_t payload_bytes(const Resource&);
// Whole payload, rows tightly packed for an image. `fill` sets every word, guard included.
void write(Device&, Resource&, std::span<const std::byte>);
void fill(Device&, Resource&, uint32_t word);
Bytes read(Device&, const Resource&);
Bytes read_guard(Device&, const Resource&);  // empty for images

using Ports = std::map<std::string, Owned>;  // by port name; the parameter block is "params"

// Resources for every port of the kernel (of one variant, where given) that `have` lacks, inputs written, and the
// parameter block. Textures that the case lacks are none. Throws std::logic_error naming kernel, case and port where an
// input is missing, has another size, or belongs to no port.
Ports make_ports(Device&, const Kernel&, const Case&, Ports have = {}, const Variant* variant = nullptr);

// ---- Commands: recorded as data, so that a checker can read them before submission
// ---------------------------------------

// Where a command touches memory; a barrier orders scopes.
enum Scope : uint32_t {
  kCompute = 1,
  kIndirect = 2,
  kGraphics = 4,
  kAttachment = 8,
  kTransfer = 16,
  kHost = 32,
  kAll = 63
};

struct Use {
  std::string port;
  const Resource* resource = nullptr;
  uint64_t offset = 0, bytes = 0;      // the bound range
  bool reads = false, writes = false;  // reflected from the SPIR-V, or fixed-function
  uint32_t scope = kCompute;
};

class Recorder;
struct Command {
  enum class Kind { dispatch, draw, clear, barrier, timestamp } kind;
  std::string label;  // "tile_classification.atomic gather.comp"
  std::vector<Use> uses = {};
  uint32_t from = 0, to = 0;  // of a barrier: scopes before and after
  std::function<void(Recorder&)> encode = {};
};
Command barrier(uint32_t from = kAll, uint32_t to = kAll);
Command timestamp(std::string label);

// A variant with its constants chosen, and perhaps one mutant.
struct Plan {
  const Kernel* kernel = nullptr;
  const Variant* variant = nullptr;
  std::map<std::string, uint32_t> constants = {};
  const Mutant* mutant = nullptr;
};
// Every combination of the variant's constants, the default first.
std::vector<std::map<std::string, uint32_t>> combinations(const Variant&);
std::string label_of(const Variant&, const std::map<std::string, uint32_t>& constants);  // "reduce[WIDTH=4]"

// The variant's passes over these resources, a barrier between each two. Pipelines are cached in the device; each
// variant's SPIR-V is first compared with the ports (layout_errors), and a mismatch throws before anything is
// dispatched.
std::vector<Command> lower(Device&, const Plan&, const Case&, const Ports&);
// Differences between the variant's reflected SPIR-V and the kernel's ports and layouts; empty if none.
std::vector<std::string> layout_errors(const Kernel&, const Variant&);
// The same for one module against ports and parameters, for tests.
std::vector<std::string> layout_errors(const Shader&, std::span<const Port>, const Layout& params);

struct Stamp {
  std::string label;
  double time_ns = 0;  // since the first timestamp of the submission
};
struct Timing {
  std::vector<Stamp> stamps;
  double cpu_ns = 0;  // process CPU time from submit to the fence
  double wall_ns = 0;
};
// Records, submits and waits, 60 s at most; on a CPU, whose driver compiles a pipeline when it first runs, 60 s more
// for each of these. `queue` 1 is the second queue where there is one.
Timing run(Device&, std::span<const Command>, uint32_t queue = 0);

// ---- Test hooks, present in builds with ASSAY_TESTS only
// -----------------------------------------------------------------------------------------------------------

// The next `after`-th checked call whose expression contains `call` returns `result` (a VkResult).
void inject_failure(const std::string& call, int32_t result, uint32_t after = 0);
// How long run() waits in place of each 60 s.
void set_fence_wait(std::chrono::nanoseconds);

}  // namespace assay::device
