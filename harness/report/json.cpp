#include "harness/report/json.h"

#include <chrono>
#include <cmath>
#include <ctime>

#include "commit.h"
#include "harness/check/judge.h"

namespace assay::report {

namespace {

Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }

Json extent_json(Extent e) { return {{"width", e.width}, {"height", e.height}}; }

Json samples_json(const std::vector<Sample>& samples) {
  Json all = Json::array();
  for (const Sample& s : samples)
    all.push_back({{"gpu_ns", number(s.gpu_ns)},
                   {"cpu_ns", number(s.cpu_ns)},
                   {"wall_ns", number(s.wall_ns)},
                   {"repeats", s.repeats}});
  return all;
}

Json bounds_json(const std::vector<check::BoundResult>& bounds) {
  Json all = Json::array();
  for (const auto& b : bounds) all.push_back(to_json(b));
  return all;
}

Json copy_json(const CopyFigure& c) {
  return {{"bytes", c.bytes},
          {"time_ns", number(c.time_ns)},
          {"bytes_per_s", number(c.bytes_per_s)},
          {"samples", samples_json(c.samples)}};
}

Json yardsticks_json(const Yardsticks& y) {
  Json copies = Json::array();
  for (const auto& [bytes, copy] : y.copies) copies.push_back(copy_json(copy));
  return {{"empty_dispatch_ns", number(y.empty_ns)},
          {"operations_per_s", number(y.operations_per_s)},
          {"copies", copies},
          {"filter_error_255ths", {{"linear", number(y.filter.linear)}, {"srgb_alpha", number(y.filter.srgb_alpha)}}},
          {"empty_samples", samples_json(y.empty_samples)},
          {"arithmetic_samples", samples_json(y.arithmetic_samples)}};
}

Json row_json(const Row& r) {
  const Verified& v = r.verified;
  Json j = {{"kernel", r.entry.kernel->name},
            {"variant", r.entry.variant->name},
            {"label", label_of(r.entry)},
            {"constants", r.entry.constants},
            {"default", r.entry.is_default},
            {"baseline", r.entry.variant->baseline},
            {"case", r.case_name},
            {"extent", extent_json(r.entry.extent)},
            {"timed", v.refused.empty()},
            {"refused", v.refused},
            {"judged", v.judged},
            {"undecided", v.undecided},
            {"violations", v.violations},
            {"nans", v.nans},
            {"bounds", bounds_json(v.bounds)},
            {"bytes_read", r.cost.bytes_read},
            {"bytes_written", r.cost.bytes_written},
            {"operations", r.cost.operations}};
  if (!v.refused.empty()) return j;
  j["dispatches"] = r.dispatches;
  j["rotation"] = {{"sets", r.sets}, {"bytes", r.rotated_bytes}, {"exceeds_cache", r.cold_enough}};
  j["gpu_ns"] = number(headline_ns(r));
  j["cpu_ns"] = number(median_cpu_ns(r.cold));
  j["hot_gpu_ns"] = number(median_gpu_ns(r.hot));
  j["copy_bytes_per_s"] = number(r.copy.bytes_per_s);
  j["limit_ns"] = number(r.limit_ns);
  j["share_of_limit"] = number(share_of_limit(r));
  j["samples"] = samples_json(r.cold);
  j["hot_samples"] = samples_json(r.hot);
  return j;
}

Json variant_json(const check::VariantResult& v) {
  Json failures = Json::array();
  for (const auto& f : v.failures)
    failures.push_back({{"text", f.text}, {"replay", f.replay}, {"file", f.file.string()}});
  return {{"name", v.name},      {"baseline", v.baseline},   {"skipped", v.skipped},
          {"trials", v.trials},  {"cases", v.cases},         {"violations", v.violations},
          {"judged", v.judged},  {"undecided", v.undecided}, {"wrong", v.wrong},
          {"nans", v.nans},      {"flaky", v.flaky},         {"bounds", bounds_json(v.bounds)},
          {"failures", failures}};
}

const char* name_of_use(Use u) { return u == Use::reads ? "reads" : u == Use::writes ? "writes" : "updates"; }
const char* name_of_kind(PortKind k) {
  return k == PortKind::buffer ? "buffer" : k == PortKind::image ? "image" : "textures";
}

Json port_json(const Port& p) {
  Json j = {{"name", p.name}, {"use", name_of_use(p.use)}, {"kind", name_of_kind(p.kind)}};
  if (p.kind == PortKind::buffer) j["element_bytes"] = p.layout.stride;
  if (p.kind == PortKind::image) j["format"] = name_of(p.format);
  if (!p.producers.empty()) j["producers"] = p.producers;
  return j;
}

Json listed_variant(const Kernel& k, const Variant& v, const std::string& label) {
  Json bounds = Json::array();
  for (const Bound& b : bounds_of(k, v))
    bounds.push_back(
        {{"name", check::name_of(b)}, {"limit", number(b.limit)}, {"worst", nullptr}, {"reason", b.reason}});
  Json needs = Json::array();
  for (const Feature f : v.needs) needs.push_back(name_of(f));
  return {{"name", label},   {"baseline", v.baseline}, {"default", v.name == k.default_variant},
          {"note", v.note},  {"needs", needs},         {"trials", 0},
          {"cases", 0},      {"violations", 0},        {"undecided", 0},
          {"bounds", bounds}};
}

Json error_json(const ErrorRow& r) {
  Json figures = Json::object();
  for (const Figure& f : r.figures)
    figures[f.quantity] = {{"value", number(f.value)}, {"goal", f.limit != 0 ? number(f.limit) : Json()}};
  return {{"kernel", r.kernel->name}, {"variant", r.label}, {"class", r.input_class}, {"figures", figures}};
}

}  // namespace

const char* commit() { return kCommit; }

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

Json to_json(const device::Info& i) {
  Json features = Json::array();
  for (const Feature f : i.features) features.push_back(name_of(f));
  return {{"index", i.index},
          {"name", i.name},
          {"uuid", i.uuid},
          {"type", i.type},
          {"driver", i.driver},
          {"driver_info", i.driver_info},
          {"api", i.api},
          {"subgroup_width", i.traits.subgroup_width},
          {"subgroup_min", i.subgroup_min},
          {"subgroup_max", i.subgroup_max},
          {"sub_pixel_bits", i.traits.sub_pixel_bits},
          {"sub_texel_bits", i.traits.sub_texel_bits},
          {"mipmap_bits", i.traits.mipmap_bits},
          {"max_buffer_range", i.max_buffer_range},
          {"shared_memory", i.shared_memory},
          {"memory_bytes", i.memory_bytes},
          {"max_groups", {i.max_groups[0], i.max_groups[1], i.max_groups[2]}},
          {"timestamp_ns", i.timestamp_ns},
          {"second_queue", i.second_queue},
          {"features", features},
          {"missing", i.missing}};
}

Json to_json(const check::BoundResult& b) {
  return {{"name", b.name}, {"limit", number(b.limit)}, {"worst", number(b.worst)}, {"reason", b.reason}};
}

Json to_json(const std::vector<check::KernelResult>& kernels) {
  Json all = Json::array();
  for (const auto& k : kernels) {
    Json variants = Json::array();
    for (const auto& v : k.variants) variants.push_back(variant_json(v));
    all.push_back({{"name", k.name}, {"variants", variants}, {"branches", k.branches}, {"complaints", k.complaints}});
  }
  return {{"kernels", all}};
}

Json to_json(const std::vector<check::MutantResult>& mutants) {
  Json all = Json::array();
  uint64_t killed = 0;
  for (const auto& m : mutants) {
    killed += !m.killed_by.empty();
    all.push_back({{"kernel", m.kernel},
                   {"variant", m.variant},
                   {"file", m.file},
                   {"n", m.n},
                   {"fault", m.fault},
                   {"killed_by", m.killed_by}});
  }
  return {{"killed", killed}, {"of", mutants.size()}, {"mutants", all}};
}

Json to_json(const Run& run, const device::Info& info) {
  Json rows = Json::array(), errors = Json::array();
  for (const Row& r : run.rows) rows.push_back(row_json(r));
  for (const ErrorRow& r : run.errors) errors.push_back(error_json(r));
  return {{"time", utc_now()},       {"commit", commit()},
          {"device", to_json(info)}, {"yardsticks", yardsticks_json(run.yardsticks)},
          {"results", rows},         {"errors", errors}};
}

Json list_json(const std::vector<const Kernel*>& kernels) {
  Json all = Json::array();
  for (const Kernel* k : kernels) {
    Json ports = Json::array(), variants = Json::array(), cases = Json::array(), extents = Json::array();
    for (const Port& p : k->ports) ports.push_back(port_json(p));
    for (const Variant& v : k->variants)
      for (const auto& constants : device::combinations(v))
        variants.push_back(listed_variant(*k, v, device::label_of(v, constants)));
    for (const HardCase& h : k->inputs.hard)
      cases.push_back({{"name", h.name}, {"why", h.why}, {"nightly", h.nightly}});
    for (const Extent e : k->extents) extents.push_back(extent_json(e));
    all.push_back({{"name", k->name},
                   {"source", k->source},
                   {"default_variant", k->default_variant},
                   {"variants", variants},
                   {"ports", ports},
                   {"hard_cases", cases},
                   {"extents", extents},
                   {"mutants", k->mutants.size()}});
  }
  return {{"kernels", all}};
}

}  // namespace assay::report
