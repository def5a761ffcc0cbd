#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/study/study.h"

namespace assay::study {

namespace {

using report::Align;
using Json = nlohmann::ordered_json;

std::string decibel_text(double mean_square) { return fmt::format("{:.1f}", decibels(mean_square)); }

double mean_saved(const Row& row) {
  double sum = 0;
  for (const Errors& e : row.errors) sum += e.saved;
  return sum / static_cast<double>(row.errors.size());
}

Json to_json(const Choice& c) {
  return {{"estimator", c.estimator}, {"tolerance", c.tolerance}, {"weber", c.weber}, {"extra_half", c.extra_half}};
}
Json finite(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }
Json to_json(const Errors& e) {
  return {{"saved", e.saved},
          {"flip_copied", e.flip_copied},
          {"flip_deblocked", e.flip_deblocked},
          {"psnr_copied_db", finite(decibels(e.square_copied))},
          {"psnr_deblocked_db", finite(decibels(e.square_deblocked))}};
}
Json merged(std::initializer_list<Json> parts) {
  Json all;
  for (const Json& part : parts) all.update(part);
  return all;
}

}  // namespace

report::Table table_of(const std::vector<Row>& rows, const std::string& input_class, bool all) {
  report::Table t{.columns = {{""}, {"estimator"}, {"tolerance", Align::right}}};
  for (const Motion& m : kMotions)
    for (const std::string what : {"saved", "FLIP", "dB"})
      t.columns.push_back({what == "saved" ? fmt::format("{}: {}", m.name, what) : what, Align::right});
  std::vector<Row> shown;
  for (const Row& row : rows)
    if (row.input_class == input_class && (all || row.in_front)) shown.push_back(row);
  std::ranges::stable_sort(shown, std::greater(), mean_saved);
  for (const Row& row : shown) {
    std::vector<std::string> cells = {row.in_front ? "*" : "", label_of(row.choice),
                                      fmt::format("{:g}", row.choice.tolerance)};
    for (const Errors& e : row.errors)
      cells.insert(cells.end(),
                   {report::percent_text(e.saved), fmt::format("{:.4f} / {:.4f}", e.flip_copied, e.flip_deblocked),
                    decibel_text(e.square_copied) + " / " + decibel_text(e.square_deblocked)});
    t.rows.push_back(std::move(cells));
  }
  return t;
}

report::Table table_of(const std::vector<Halved>& all) {
  report::Table t{.columns = {{"luma"},
                              {"estimator"},
                              {"tolerance", Align::right},
                              {"saved", Align::right},
                              {"dB copied", Align::right},
                              {"deblocked", Align::right},
                              {"gained", Align::right},
                              {"by means of what is shown", Align::right},
                              {"where luma that did not move shares alike", Align::right}}};
  for (const Halved& h : all)
    t.rows.push_back({kMotions[h.motion].name, h.choice.estimator, fmt::format("{:.4f}", h.choice.tolerance),
                      report::percent_text(h.saved), decibel_text(h.square_copied), decibel_text(h.square_deblocked),
                      fmt::format("{:.1f}", decibels(h.square_deblocked) - decibels(h.square_copied)),
                      fmt::format("{:.1f}", decibels(h.square_of_shown) - decibels(h.square_copied)),
                      fmt::format("{:.1f}", decibels(h.own_deblocked) - decibels(h.own_copied))});
  return t;
}

Json to_json(const std::vector<Outcome>& outcomes) {
  Json all = Json::array();
  for (const Outcome& o : outcomes)
    all.push_back(merged({{{"class", o.input_class}, {"picture", o.picture}, {"luma", kMotions[o.motion].name}},
                          to_json(o.choice),
                          to_json(o.errors)}));
  return all;
}

Json to_json(const std::vector<Halved>& halved) {
  Json all = Json::array();
  for (const Halved& h : halved)
    all.push_back(merged({{{"luma", kMotions[h.motion].name}},
                          to_json(h.choice),
                          {{"saved", h.saved},
                           {"psnr_copied_db", finite(decibels(h.square_copied))},
                           {"psnr_deblocked_db", finite(decibels(h.square_deblocked))},
                           {"psnr_deblocked_as_shown_db", finite(decibels(h.square_of_shown))},
                           {"psnr_copied_alike_db", finite(decibels(h.own_copied))},
                           {"psnr_deblocked_alike_db", finite(decibels(h.own_deblocked))}}}));
  return all;
}

}  // namespace assay::study
