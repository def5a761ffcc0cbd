// What a device's word is not taken for.
#include <cmath>
#include <cstring>

#include "harness/device/internal.h"

namespace assay {

namespace anisotropy_probe {
Kernel describe();  // harness/device/probes
}

namespace device {

// The footprint is 32 texels by 4: with anisotropy a sample is as wide as the shorter way, level 2 (Vulkan, LOD
// Operation: the longer over the number of taps), without as the longer, level 5. How many taps there are is the
// device's choice, so a level either way is taken. lavapipe 22.3 reads level 0.
bool works_anisotropically(Device& d) {
  static const Kernel probe = anisotropy_probe::describe();
  const Case c = probe.typical({1, 1});
  const Ports ports = make_ports(d, probe, c);
  run(d, lower(d, {.kernel = &probe, .variant = &probe.variants[0]}, c, ports));
  const Bytes reds = read(d, *ports.at("reds"));
  for (size_t i = 0; i < 2; ++i) {
    float red = 0;
    std::memcpy(&red, &reds[i * sizeof red], sizeof red);
    if (!(std::fabs(red * 255 / 16 - 2) <= 1)) return false;
  }
  return true;
}

}  // namespace device
}  // namespace assay
