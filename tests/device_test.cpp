// The device layer: choosing a device, failures and recovery, transfers, passes.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "harness/device/device.h"
#include "harness/oracle.h"
#include "tests/planted/device_copy/layout.h"

namespace assay {
const std::vector<Kernel>& planted_kernels();
}

namespace {

using namespace assay;
using device_copy::CopyParams;
using device_copy::Pair;

const Kernel& planted(const std::string& name) {
  for (const Kernel& k : planted_kernels())
    if (k.name == name) return k;
  throw std::logic_error("no planted kernel " + name);
}

const Variant& variant_of(const Kernel& k, const std::string& name) {
  for (const Variant& v : k.variants)
    if (v.name == name) return v;
  throw std::logic_error("no variant " + name);
}

Case copy_case(uint32_t count) {
  Case c = {.name = "copy"};
  c.extent = {5, 3};
  c.set_params(CopyParams{count, 10});
  std::vector<Pair> pairs(count);
  for (uint32_t i = 0; i < count; ++i) pairs[i] = {i, vec3(float(i), 2, 3), {4, 5}};
  c.set_input("pairs", pairs);
  c.set_input("arguments", std::vector<DispatchArgs>{{1, 1, 1}, {2, 2, 2}, {0, 1, 1}});
  return c;
}

template <class T>
std::vector<T> values(const Bytes& bytes) {
  std::vector<T> v(bytes.size() / sizeof(T));
  std::memcpy(v.data(), bytes.data(), bytes.size());
  return v;
}

struct Ran {
  device::Ports ports;
  device::Timing timing;
};
Ran run_variant(device::Device& d, const Kernel& k, const std::string& variant, const Case& c,
                std::map<std::string, uint32_t> constants = {}) {
  Ran r;
  r.ports = device::make_ports(d, k, c);
  for (const Port& p : k.ports)
    if (p.use == Use::writes) device::fill(d, *r.ports.at(p.name), 0xdeadbeef);
  std::vector<device::Command> commands = {device::timestamp("start")};
  for (auto& command : device::lower(d, {&k, &variant_of(k, variant), std::move(constants)}, c, r.ports))
    commands.push_back(command);
  commands.push_back(device::timestamp("end"));
  r.timing = device::run(d, commands);
  return r;
}

class Device : public ::testing::Test {
 protected:
  device::Handle handle = device::open({});
  device::Device& d = *handle;
};

TEST_F(Device, copies_a_buffer) {
  const Case c = copy_case(1000);
  const Ran r = run_variant(d, planted("device_copy"), "direct", c, {{"SCALE", 3}, {"GROUP", 32}});
  const auto copies = values<Pair>(device::read(d, *r.ports.at("copies")));
  for (uint32_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(copies[i].key, i * 3 + 10);
    EXPECT_EQ(copies[i].place, vec3(float(i), 2, 3));
    EXPECT_EQ(copies[i].weights[1], float(device::info(d).traits.subgroup_width));
  }
  EXPECT_EQ(r.timing.stamps.size(), 2u);
  EXPECT_GT(r.timing.stamps[1].time_ns, 0);
  EXPECT_GT(r.timing.cpu_ns, 0);
  for (const uint32_t w : values<uint32_t>(device::read_guard(d, *r.ports.at("copies")))) EXPECT_EQ(w, 0xdeadbeefu);
}

TEST_F(Device, a_stray_write_lands_in_the_guard) {
  const Ran r = run_variant(d, planted("device_copy"), "stray", copy_case(70));
  EXPECT_EQ(values<uint32_t>(device::read_guard(d, *r.ports.at("copies")))[0], 0xbadu);
}

TEST_F(Device, repeats_an_indirect_dispatch_a_row) {
  const Ran r = run_variant(d, planted("device_copy"), "rows", copy_case(1));
  const auto rows = values<uint32_t>(device::read(d, *r.ports.at("rows")));
  EXPECT_EQ(rows[0], 7u + 1);
  EXPECT_EQ(rows[1], 7u + 8);
  EXPECT_EQ(rows[2], 7u);
  EXPECT_EQ(rows[3], 7u);
}

TEST_F(Device, writes_a_packed_format_through_a_second_view) {
  const Ran r = run_variant(d, planted("device_copy"), "image", copy_case(1));
  const auto texels = values<uint32_t>(device::read(d, *r.ports.at("stored")));
  for (uint32_t y = 0; y < 3; ++y)
    for (uint32_t x = 0; x < 5; ++x) EXPECT_EQ(texels[y * 5 + x], x + 1000 * y);
}

}  // namespace
