// What variable rates save and what they cost the picture, by estimator and tolerance: the study behind
// `assay bench vrcs`.
#pragma once
#include <nlohmann/json.hpp>

#include "harness/report/table.h"
#include "harness/study/chain.h"

namespace assay::study {

// How far the picture has moved since its luma was stored, pixels to the right and down.
struct Motion {
  const char* name;
  double right, down;
};
constexpr Motion kMotions[] = {{"static", 0, 0}, {"0.37 px", 0.37, 0.21}, {"3.3 px", 3.3, 1.7}};

constexpr double kMostFlip = 0.02;  // mean FLIP against 1x1 that a default may have

// Of displayed pictures against 1x1. FLIP of 8-bit codes, as `assay diff`; mean squares of what is displayed before it
// is rounded to codes, 0 to 1, over red, green and blue: codes would drown what lies below 59 dB.
struct Errors {
  double saved = 0;  // share of pixels not shaded
  double flip_copied = 0, flip_deblocked = 0;
  double square_copied = 0, square_deblocked = 0;
};
double decibels(double mean_square);  // peak 1; infinite of 0

struct Outcome {
  std::string input_class, picture;
  size_t motion = 0;  // of kMotions
  Choice choice;
  Errors errors;
};

// The variants of vrcs_shading_rate named, or all; each plain, after Weber and with an extra half of 0.5, at each
// tolerance.
std::vector<Choice> choices(const std::vector<std::string>& estimators);
// One after the other, chosen by its luma under every motion.
std::vector<Outcome> try_all(device::Device&, const Picture&, const std::vector<Choice>&,
                             const std::function<void(uint64_t done, uint64_t of)>& tell);

// Means over a class's pictures, in the order of first appearance.
struct Row {
  std::string input_class;
  Choice choice;
  std::array<Errors, std::size(kMotions)> errors;
  bool in_front =
      false;  // nobody of the class has less FLIP, deblocked, and saves as much: by their means over motions
};
std::vector<Row> rows_of(const std::vector<Outcome>&);

// Saves most, over all classes and motions, of those whose FLIP, deblocked, is kMostFlip at most in each class and
// motion. None: no such choice.
std::optional<Choice> best_of(const std::vector<Row>&);

// Estimators at equal saving: constant tolerances that save half of a picture's pixels, as near as bisection gets.
struct Halved {
  Choice choice;
  size_t motion = 0;
  double saved = 0, square_copied = 0, square_deblocked = 0;
  double square_of_shown = 0;  // if the deblocker took means of what is displayed, not of radiance
  // Over the pixels alone that would be shared alike at that tolerance if the luma had not moved.
  double own_copied = 0, own_deblocked = 0;
};
std::vector<Halved> at_half(device::Device&, const Picture&, const std::vector<std::string>& estimators);

// A class's choices, most saved first: all, or those in front; of copies and, behind the stroke, deblocked.
report::Table table_of(const std::vector<Row>&, const std::string& input_class, bool all);
report::Table table_of(const std::vector<Halved>&);
nlohmann::ordered_json to_json(const std::vector<Outcome>&);
nlohmann::ordered_json to_json(const std::vector<Halved>&);

}  // namespace assay::study
