// Triangles with weights from elsewhere, so that the oracle is not its own witness.
#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

#include "kernels/attribute_interpolation/inputs.h"
#include "kernels/attribute_interpolation/triangle.h"

namespace assay::attribute_interpolation {

namespace {

const char* const kVectors =
#include "fixtures/attribute_interpolation/bary_hard_cases.csv.inc"
    ;

// Columns after the two of text: W, H, i, j, nine coordinates, then the answers and figures of the formulas' errors.
enum Column { viewport_width, viewport_height, pixel_x, pixel_y, first_coordinate, first_answer = 13, columns = 24 };

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::istringstream cells(line.substr(line.find("\",") + 2));
  std::string cell;
  std::getline(cells, cell, ',');
  while (std::getline(cells, cell, ',')) numbers.push_back(std::strtod(cell.c_str(), nullptr));
  if (numbers.size() != columns) throw std::logic_error("a vector of another length: " + line);
  return numbers;
}

// Weights and derivatives, d lambda_1/dx and d lambda_2/dx, then along y, as the oracle has them against those given.
void verify(const ClipSample& s, const std::vector<double>& numbers) {
  const std::vector<ClipSample> samples = {s};
  const Case c = clip_case("", samples, 1);
  const Hit h = hit(*triangle_at(scene_of(c), 0), Formula::paired);
  if (!h.determined) throw std::logic_error("a vector's weights are not determined, even in pairs of floats");
  for (int k = 0; k < 7; ++k) {
    const double got = k < 3 ? h.weights[k].value : h.derivatives[k - 3].value,
                 want = numbers[static_cast<size_t>(first_answer) + static_cast<size_t>(k)];
    if (!(std::fabs(got - want) <= 1e-14 * std::max(1.0, std::fabs(want))))
      throw std::logic_error(fmt::format("the oracle says {}, a vector {}", got, want));
  }
}

}  // namespace

Case published_vectors() {
  std::istringstream lines(kVectors);
  std::vector<ClipSample> samples;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] != '"') continue;  // origin and heads
    const std::vector<double> n = numbers_of(line);
    const auto corner = [&](uint k) {
      const double* v = &n[first_coordinate + 3u * k];
      return vec3(v[0], v[1], v[2]);
    };
    samples.push_back(
        {corner(0), corner(1), corner(2), {n[pixel_x], n[pixel_y]}, {n[viewport_width], n[viewport_height]}});
    verify(samples.back(), n);
  }
  return clip_case("published_vectors", samples, 16);
}

}  // namespace assay::attribute_interpolation
