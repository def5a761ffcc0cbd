#include <fmt/format.h>

#include <algorithm>

#include "harness/kernel.h"
#include "harness/study/particle_light.h"

namespace assay::study {

namespace {

using report::Align;
using Json = nlohmann::ordered_json;

std::string size_text(Extent e) { return fmt::format("{}x{}", e.width, e.height); }
// "1.83", of times and counts against those of the first row.
std::string ratio_text(double value, double first) { return first > 0 ? fmt::format("{:.2f}", value / first) : "-"; }

}  // namespace

report::Table table_of(const std::vector<ParticleOutcome>& all, const std::string& input_class, bool whole) {
  report::Table t{.columns = {{""},
                              {"way"},
                              {"rms", Align::right},
                              {"max", Align::right},
                              {"pixels", Align::right},
                              {"texels", Align::right},
                              {"time", Align::right},
                              {""}}};
  std::vector<ParticleOutcome> shown;
  for (const ParticleOutcome& o : all)
    if (o.input_class == input_class && (whole || o.in_front || o.is_default)) shown.push_back(o);
  std::ranges::stable_sort(shown, {}, time_of);
  for (const ParticleOutcome& o : shown)
    t.rows.push_back({o.in_front ? "*" : "", label_of(o.way), report::number_text(o.rms), report::number_text(o.most),
                      report::time_text(o.draw_ns), o.way.side ? report::time_text(o.light_ns) : "-",
                      report::time_text(time_of(o)), o.is_default ? "default" : ""});
  return t;
}

report::Table table_of(const std::vector<ParticleFrame>& frames) {
  report::Table t{.columns = {{"size"}}};
  for (const char* head : {"lit", "texels", "particle_rects", "particle_light_atlas", "particles"})
    for (const char* column : {head, "x"}) t.columns.push_back({column, Align::right});
  for (const ParticleFrame& f : frames) {
    const ParticleFrame& first = frames[0];
    t.rows.push_back({size_text(f.size), fmt::format("{}", f.lit), ratio_text(f.lit, first.lit),
                      fmt::format("{}", f.texels), ratio_text(f.texels, first.texels), report::time_text(f.rects_ns),
                      ratio_text(f.rects_ns, first.rects_ns), report::time_text(f.light_ns),
                      ratio_text(f.light_ns, first.light_ns), report::time_text(f.draw_ns),
                      ratio_text(f.draw_ns, first.draw_ns)});
  }
  return t;
}

Json to_json(const std::vector<ParticleOutcome>& all) {
  Json json = Json::array();
  for (const ParticleOutcome& o : all)
    json.push_back({{"class", o.input_class},
                    {"filter", o.way.filter},
                    {"encoding", o.way.encoding},
                    {"side", o.way.side},
                    {"rms", o.rms},
                    {"max", o.most},
                    {"pixels_ns", o.draw_ns},
                    {"texels_ns", o.light_ns},
                    {"front", o.in_front},
                    {"default", o.is_default}});
  return json;
}

Json to_json(const std::vector<ParticleFrame>& frames) {
  Json json = Json::array();
  for (const ParticleFrame& f : frames)
    json.push_back({{"width", f.size.width},
                    {"height", f.size.height},
                    {"lit", f.lit},
                    {"texels", f.texels},
                    {"particle_rects_ns", f.rects_ns},
                    {"particle_light_atlas_ns", f.light_ns},
                    {"particles_ns", f.draw_ns}});
  return json;
}

}  // namespace assay::study
